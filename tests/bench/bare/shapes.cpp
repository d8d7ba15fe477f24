// The shapes of the bare programs, with the vertices of the language's shapes of these names.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "bare.h"

namespace bare {
namespace {

void add(Shape& shape, const glm::dvec3& position, const glm::dvec3& normal) {
    shape.vertices.push_back({glm::vec3(position), glm::vec3(normal)});
}

void triangle(Shape& shape, std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t each : {a, b, c}) shape.indices.push_back(static_cast<std::uint32_t>(each));
}

/// The triangles of columns x rows cells, whose vertices begin at `first`.
void cells(Shape& shape, std::size_t first, std::size_t columns, std::size_t rows) {
    for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
            const std::size_t low = first + j * (columns + 1) + i, high = low + columns + 1;
            triangle(shape, low, low + 1, high + 1);
            triangle(shape, low, high + 1, high);
        }
}

/// The point of the unit circle after `part` of `whole` of a turn.
glm::dvec2 turn(std::size_t part, std::size_t whole) {
    const double angle =
        2 * 3.14159265358979323846 * static_cast<double>(part % whole) / static_cast<double>(whole);
    const auto exact = [](double value) { return std::abs(value) < 1e-15 ? 0. : value; };
    return {exact(std::cos(angle)), exact(std::sin(angle))};
}

}  // namespace

Shape box(double side) {
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const glm::dvec3 faces[6][2] = {{-z, y}, {z, y}, {x, -z}, {x, z}, {x, y}, {-x, y}};
    Shape shape;
    for (const auto& [s, t] : faces) {
        const glm::dvec3 out = glm::cross(s, t);
        for (const double b : {-1., 1.})
            for (const double a : {-1., 1.}) add(shape, side / 2 * (out + a * s + b * t), out);
        cells(shape, shape.vertices.size() - 4, 1, 1);
    }
    return shape;
}

Shape skyBox(double side) {
    Shape shape;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1., -1.}) {
            glm::dvec3 out{0}, s{0}, t{0};
            out[axis] = sign;
            s[(axis + 1) % 3] = 1;
            t[(axis + 2) % 3] = -sign;
            for (const double b : {-1., 1.})
                for (const double a : {-1., 1.}) add(shape, side / 2 * (out + a * s + b * t), -out);
            cells(shape, shape.vertices.size() - 4, 1, 1);
        }
    return shape;
}

Shape plane(double half) {
    Shape shape;
    for (const double z : {half, -half})
        for (const double x : {-half, half}) add(shape, {x, 0, z}, {0, 1, 0});
    cells(shape, 0, 1, 1);
    return shape;
}

Shape pyramid(double base, double height) {
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const glm::dvec3 sides[4][2] = {{x, -z}, {-x, z}, {z, x}, {-z, -x}};
    Shape shape;
    for (const auto& [out, s] : sides) {
        const glm::dvec3 normal = glm::cross(s, glm::normalize(height * y - base / 2 * out));
        add(shape, base / 2 * (out - s), normal);
        add(shape, base / 2 * (out + s), normal);
        add(shape, height * y, normal);
        triangle(shape, shape.vertices.size() - 3, shape.vertices.size() - 2, shape.vertices.size() - 1);
    }
    for (const double b : {-1., 1.})
        for (const double a : {-1., 1.}) add(shape, base / 2 * (a * x + b * z), -y);
    cells(shape, 12, 1, 1);
    return shape;
}

Shape torus(double ring, double tube, int sides, int rings) {
    const auto rows = static_cast<std::size_t>(sides), columns = static_cast<std::size_t>(rings);
    Shape shape;
    for (std::size_t j = 0; j <= rows; ++j)
        for (std::size_t i = 0; i <= columns; ++i) {
            const glm::dvec2 u = turn(i, columns), v = turn(j, rows);
            const double distance = ring + tube * v.x;
            add(shape, {distance * u.x, distance * u.y, tube * v.y}, {v.x * u.x, v.x * u.y, v.y});
        }
    cells(shape, 0, columns, rows);
    return shape;
}

Shape sphere(double radius, int slices, int stacks) {
    const auto columns = static_cast<std::size_t>(slices), rows = static_cast<std::size_t>(stacks);
    Shape shape;
    const auto point = [&](const glm::dvec2& around, const glm::dvec2& fromSouth) {
        const glm::dvec3 normal{-around.x * fromSouth.y, -fromSouth.x, around.y * fromSouth.y};
        add(shape, radius * normal, normal);
    };
    for (std::size_t i = 0; i < columns; ++i) point({1, 0}, {1, 0});
    for (std::size_t j = 1; j < rows; ++j)
        for (std::size_t i = 0; i <= columns; ++i) point(turn(i, columns), turn(j, 2 * rows));
    for (std::size_t i = 0; i < columns; ++i) point({1, 0}, {-1, 0});
    const std::size_t last = columns + (rows - 2) * (columns + 1), north = last + columns + 1;
    for (std::size_t i = 0; i < columns; ++i) triangle(shape, i, columns + i + 1, columns + i);
    cells(shape, columns, columns, rows - 2);
    for (std::size_t i = 0; i < columns; ++i) triangle(shape, last + i, last + i + 1, north + i);
    return shape;
}

Shape cylinder(double radius, double height, int slices) {
    const auto columns = static_cast<std::size_t>(slices);
    Shape shape;
    const auto around = [&](std::size_t i) {
        const glm::dvec2 at = turn(i, columns);
        return glm::dvec3{-at.x, 0, at.y};
    };
    for (const double y : {0., height})
        for (std::size_t i = 0; i <= columns; ++i)
            add(shape, radius * around(i) + glm::dvec3{0, y, 0}, around(i));
    cells(shape, 0, columns, 1);
    for (const double y : {height, 0.}) {
        const std::size_t centre = shape.vertices.size(), rim = centre + 1;
        const glm::dvec3 normal{0, y > 0 ? 1 : -1, 0};
        add(shape, {0, y, 0}, normal);
        for (std::size_t i = 0; i <= columns; ++i)
            add(shape, radius * around(i) + glm::dvec3{0, y, 0}, normal);
        for (std::size_t i = 0; i < columns; ++i)
            y > 0 ? triangle(shape, centre, rim + i, rim + i + 1)
                  : triangle(shape, centre, rim + i + 1, rim + i);
    }
    return shape;
}

}  // namespace bare
