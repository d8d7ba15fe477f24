#include "geometry/shapes/polyhedra.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {

Mesh box(double dx, double dy, double dz) {
    assert(dx >= 0 && dy >= 0 && dz >= 0);
    struct Face {
        glm::dvec3 s, t;
    };
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const std::array<Face, 6> faces{{{-z, y}, {z, y}, {x, -z}, {x, z}, {x, y}, {-x, y}}};
    const glm::dvec3 half = glm::dvec3{dx, dy, dz} / 2.0;
    Surface surface(Topology::triangles, 2, boxCounts());
    for (const Face& face : faces) {
        const std::uint32_t base = surface.size();
        const glm::dvec3 normal = glm::cross(face.s, face.t);
        for (const double t : {0., 1.})
            for (const double s : {0., 1.})
                surface.add({.position = half * (normal + (2 * s - 1) * face.s + (2 * t - 1) * face.t),
                             .normal = normal,
                             .tangent = face.t,
                             .texCoord = {s, t, 0}});
        surface.gridCells(base, 1, 1);
    }
    return std::move(surface).finish();
}

Mesh skyBox(double side) {
    assert(side >= 0);
    Surface surface(Topology::triangles, 3, boxCounts());
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1., -1.}) {
            glm::dvec3 out{0}, s{0}, t{0};
            out[axis] = sign;
            s[(axis + 1) % 3] = 1;
            t[(axis + 2) % 3] = -sign;  // s x t points to the centre
            const std::uint32_t base = surface.size();
            for (const double b : {-1., 1.})
                for (const double a : {-1., 1.}) {
                    const glm::dvec3 direction = out + a * s + b * t;
                    surface.add({.position = side / 2 * direction,
                                 .normal = -out,
                                 .tangent = fallbackTangent(-out),
                                 .texCoord = direction});
                }
            surface.gridCells(base, 1, 1);
        }
    return std::move(surface).finish();
}

Mesh wireBox(double dx, double dy, double dz) {
    assert(dx >= 0 && dy >= 0 && dz >= 0);
    const glm::dvec3 half = glm::dvec3{dx, dy, dz} / 2.0;
    Surface surface(Topology::lines, 3, wireBoxCounts());
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place{corner & 1, corner >> 1 & 1, corner >> 2};
        const glm::dvec3 sign = 2.0 * place - 1.0;
        const glm::dvec3 normal = unitOr(half * sign, glm::normalize(sign));
        surface.add({.position = half * sign,
                     .normal = normal,
                     .tangent = fallbackTangent(normal),
                     .texCoord = place});
    }
    for (std::uint32_t bit = 1; bit < 8; bit *= 2)
        for (std::uint32_t corner = 0; corner < 8; ++corner)
            if ((corner & bit) == 0) surface.segment(corner, corner | bit);
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kSides[] = {sizeArgument("dx", 2), sizeArgument("dy", 2), sizeArgument("dz", 2)};
constexpr ShapeArgument kSide[] = {sizeArgument("side", 1)};
constexpr ShapeArgument kSkySide[] = {sizeArgument("side", 2)};

}  // namespace

constexpr PrimitiveSpec kBoxRow{.names = {"Box", "Cube"},
                                .arguments = kSides,
                                .summary = "box with these sides, centred",
                                .counts = [](Numbers) { return boxCounts(); },
                                .make = [](Numbers n) { return box(n[0], n[1], n[2]); },
                                .isClosed = true,
                                .oneSizeForAll = true,
                                .twin = &kWireBoxRow};

constexpr PrimitiveSpec kWireCubeRow{.names = {"WireCube"},
                                     .arguments = kSide,
                                     .summary = "edges of a cube",
                                     .topology = Topology::lines,
                                     .counts = [](Numbers) { return wireBoxCounts(); },
                                     .make = [](Numbers n) { return wireBox(n[0], n[0], n[0]); },
                                     .twin = &kBoxRow};

constexpr PrimitiveSpec kWireBoxRow{.names = {"WireBox"},
                                    .arguments = kSides,
                                    .summary = "edges of a box",
                                    .topology = Topology::lines,
                                    .counts = [](Numbers) { return wireBoxCounts(); },
                                    .make = [](Numbers n) { return wireBox(n[0], n[1], n[2]); },
                                    .twin = &kBoxRow};

constexpr PrimitiveSpec kSkyBoxRow{.names = {"SkyBox"},
                                   .arguments = kSkySide,
                                   .summary = "cube around the eye, seen from inside, behind everything",
                                   .space = Space::sky,
                                   .counts = [](Numbers) { return boxCounts(); },
                                   .make = [](Numbers n) { return skyBox(n[0]); },
                                   .isClosed = true};

namespace {

constexpr ShapeArgument kPyramidArguments[] = {sizeArgument("base", 2), sizeArgument("height", 1)};

}  // namespace

Mesh pyramid(double base, double height) {
    assert(base >= 0 && height >= 0);
    struct Side {
        glm::dvec3 out, s;
    };
    const glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const std::array<Side, 4> sides{{{x, -z}, {-x, z}, {z, x}, {-z, -x}}};
    const double half = base / 2;
    Surface surface(Topology::triangles, 2, pyramidCounts());
    for (const Side& side : sides) {
        const std::uint32_t first = surface.size();
        const glm::dvec3 tangent = unitOr(height * y - half * side.out, y);
        const glm::dvec3 normal = glm::cross(side.s, tangent);
        const auto add = [&](const glm::dvec3& position, double s, double t) {
            surface.add({.position = position, .normal = normal, .tangent = tangent, .texCoord = {s, t, 0}});
        };
        add(half * (side.out - side.s), 0, 0);
        add(half * (side.out + side.s), 1, 0);
        add(height * y, .5, 1);
        surface.triangle(first, first + 1, first + 2);
    }
    const std::uint32_t bottom = surface.size();
    for (const double t : {0., 1.})
        for (const double s : {0., 1.})
            surface.add({.position = half * ((2 * s - 1) * x + (2 * t - 1) * z),
                         .normal = -y,
                         .tangent = z,
                         .texCoord = {s, t, 0}});
    surface.gridCells(bottom, 1, 1);
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kPyramidRow{.names = {"Pyramid"},
                                    .arguments = kPyramidArguments,
                                    .summary = "closed pyramid with a square base at y = 0",
                                    .counts = [](Numbers) { return pyramidCounts(); },
                                    .make = [](Numbers n) { return pyramid(n[0], n[1]); },
                                    .isClosed = true};

namespace {

constexpr ShapeArgument kTetrahedronArguments[] = {sizeArgument("radius", 1)};

}  // namespace

Mesh tetrahedron(double radius) {
    assert(radius >= 0);
    // On the unit sphere: the three corners of the bottom, counter-clockwise seen from above, and the apex.
    std::array<glm::dvec3, 4> corners{};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 around = std::sqrt(8.) / 3 * unitTurn((9 + 4 * i) % 12, 12);
        corners[static_cast<std::size_t>(i)] = {-around.x, -1 / 3., around.y};
    }
    corners[3] = {0, 1, 0};
    constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{{{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {2, 1, 0}}};
    constexpr std::array<glm::dvec3, 3> kTexCoords{{{0, 0, 0}, {1, 0, 0}, {.5, 1, 0}}};

    Surface surface(Topology::triangles, 2, tetrahedronCounts());
    for (const auto& face : kFaces) {
        const std::uint32_t first = surface.size();
        const glm::dvec3 a = corners[face[0]], b = corners[face[1]], c = corners[face[2]];
        const glm::dvec3 tangent = glm::normalize(c - .5 * (a + b));
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, tangent));
        for (std::size_t i = 0; i < 3; ++i)
            surface.add({.position = radius * corners[face[i]],
                         .normal = normal,
                         .tangent = tangent,
                         .texCoord = kTexCoords[i]});
        surface.triangle(first, first + 1, first + 2);
    }
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kTetrahedronRow{.names = {"Tetrahedron"},
                                        .arguments = kTetrahedronArguments,
                                        .summary = "regular tetrahedron, centred, its corners at this radius",
                                        .counts = [](Numbers) { return tetrahedronCounts(); },
                                        .make = [](Numbers n) { return tetrahedron(n[0]); },
                                        .isClosed = true};

namespace {

using Icosahedron = std::array<glm::dvec3, 12>;

/// Twelve unit vectors, numbered like the pentagons.
Icosahedron icosahedron() {
    const double sine = 1 / std::sqrt(5.), cosine = 2 / std::sqrt(5.);  // of the latitude atan(1/2)
    const auto at = [&](int twentieth, double height) {                 // s = twentieth / 20
        const glm::dvec2 around = unitTurn(twentieth % 20, 20);
        return glm::dvec3{-around.x * cosine, height, around.y * cosine};
    };
    Icosahedron vertices;
    vertices[0] = {0, 1, 0};
    vertices[11] = {0, -1, 0};
    for (std::size_t k = 0; k < 5; ++k) {
        vertices[1 + k] = at(5 + 4 * static_cast<int>(k), sine);
        vertices[6 + k] = at(7 + 4 * static_cast<int>(k), -sine);
    }
    return vertices;
}

/// A corner of the truncated icosahedron: a third of the way from one vertex of the icosahedron to another.
/// The number identifies the corner; by it both faces at an edge see the ends of the edge in the same order.
struct Corner {
    int number = 0;
    glm::dvec3 place{0};
};

struct Face {
    glm::dvec3 centre{0};
    std::vector<Corner> corners;
};

Corner cornerBetween(const Icosahedron& vertices, std::size_t near, std::size_t far) {
    return {static_cast<int>(near * vertices.size() + far), (2.0 * vertices[near] + vertices[far]) / 3.0};
}

Face pentagon(const Icosahedron& vertices, std::size_t vertex) {
    Face face;
    for (std::size_t other = 0; other < vertices.size(); ++other)
        if (other != vertex && glm::dot(vertices[vertex], vertices[other]) > 0)
            face.corners.push_back(cornerBetween(vertices, vertex, other));
    // The plane of the corners is at the distance (2 + cos of the edge's angle) / 3.
    face.centre = vertices[vertex] * ((2 + 1 / std::sqrt(5.)) / 3);
    return face;
}

Face hexagon(const Icosahedron& vertices, const std::array<std::size_t, 3>& corners) {
    Face face;
    for (const std::size_t a : corners)
        for (const std::size_t b : corners)
            if (a != b) face.corners.push_back(cornerBetween(vertices, a, b));
    face.centre = (vertices[corners[0]] + vertices[corners[1]] + vertices[corners[2]]) / 3.0;
    return face;
}

std::vector<Face> faces() {
    const Icosahedron vertices = icosahedron();
    std::vector<Face> all;
    for (std::size_t i = 0; i < vertices.size(); ++i) all.push_back(pentagon(vertices, i));
    const auto upper = [](std::size_t k) { return 1 + k % 5; };
    const auto lower = [](std::size_t k) { return 6 + k % 5; };
    for (std::size_t k = 0; k < 5; ++k) all.push_back(hexagon(vertices, {0, upper(k), upper(k + 1)}));
    for (std::size_t k = 0; k < 5; ++k) all.push_back(hexagon(vertices, {upper(k), upper(k + 1), lower(k)}));
    for (std::size_t k = 0; k < 5; ++k) all.push_back(hexagon(vertices, {upper(k), lower(k + 4), lower(k)}));
    for (std::size_t k = 0; k < 5; ++k) all.push_back(hexagon(vertices, {11, lower(k + 4), lower(k)}));
    return all;
}

/// The flat frame of a face: t toward the north pole, s to its right seen from outside.
struct Frame {
    glm::dvec3 s, t;
};

Frame frameOf(const Face& face) {
    const glm::dvec3 t = fallbackTangent(face.centre);
    return {glm::cross(t, glm::normalize(face.centre)), t};
}

/// Sorts the corners counter-clockwise, beginning at the t direction.
void sortCorners(Face& face, const Frame& frame) {
    const auto angle = [&](const Corner& corner) {
        const glm::dvec3 arm = corner.place - face.centre;
        constexpr double kTurn = 2 * std::numbers::pi;
        // A corner exactly in the t direction comes first, however it was rounded.
        const double fromT = std::atan2(-glm::dot(arm, frame.s), glm::dot(arm, frame.t)) + .01;
        return fromT < 0 ? fromT + kTurn : fromT;
    };
    std::ranges::sort(face.corners, [&](const Corner& a, const Corner& b) { return angle(a) < angle(b); });
}

/// Returns centre * c + a * wa + b * wb. Both faces at a shared edge get the same bits, even if the compiler
/// fuses operations.
glm::dvec3 blend(const glm::dvec3& centre, double c, const Corner& a, double wa, const Corner& b, double wb) {
    if (b.number < a.number) return blend(centre, c, b, wb, a, wa);
    glm::dvec3 point;
    for (int i = 0; i < 3; ++i) point[i] = std::fma(wb, b.place[i], std::fma(wa, a.place[i], c * centre[i]));
    return point;
}

/// The values that all fans of a ball share.
struct Ball {
    double radius = 1;
    int cuts = 8;
};

void addFanTriangle(Surface& surface, const Ball& ball, const Face& face, const Frame& frame, const Corner& a,
                    const Corner& b) {
    const std::uint32_t base = surface.size();
    const double diameter = 2 * glm::length(a.place - face.centre);
    const glm::dvec3 bisector = unitOr((a.place + b.place) / 2.0 - face.centre, {0, 0, 0});
    for (int row = 0; row <= ball.cuts; ++row)
        for (int column = 0; column <= row; ++column) {
            const glm::dvec3 flat = blend(face.centre, static_cast<double>(ball.cuts - row) / ball.cuts, a,
                                          static_cast<double>(row - column) / ball.cuts, b,
                                          static_cast<double>(column) / ball.cuts);
            const glm::dvec3 normal = glm::normalize(flat), arm = flat - face.centre;
            const bool isPole = flat.x == 0 && flat.z == 0;
            surface.add(
                {.position = ball.radius * normal,
                 .normal = normal,
                 .tangent = isPole ? -normal.y * bisector : fallbackTangent(normal),
                 .texCoord = {.5 + glm::dot(arm, frame.s) / diameter, .5 + glm::dot(arm, frame.t) / diameter,
                              static_cast<double>(row) / ball.cuts}});
        }
    const auto at = [&](std::uint32_t row, std::uint32_t column) {
        return base + row * (row + 1) / 2 + column;
    };
    const auto rows = static_cast<std::uint32_t>(ball.cuts);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column <= row; ++column) {
            surface.triangle(at(row, column), at(row + 1, column), at(row + 1, column + 1));
            if (column < row) surface.triangle(at(row, column), at(row + 1, column + 1), at(row, column + 1));
        }
}

}  // namespace

Mesh soccerball(double radius, int cuts) {
    assert(radius >= 0 && cuts >= 1);
    Surface surface(Topology::triangles, 3, soccerballCounts(cuts));
    Attribute faceIndex{std::string(kFaceIndex), 1, {}};
    faceIndex.values.reserve(soccerballCounts(cuts).vertices);
    float number = 0;
    for (Face& face : faces()) {
        const Frame frame = frameOf(face);
        sortCorners(face, frame);
        const std::size_t corners = face.corners.size();
        for (std::size_t i = 0; i < corners; ++i)
            addFanTriangle(surface, {radius, cuts}, face, frame, face.corners[i],
                           face.corners[(i + 1) % corners]);
        faceIndex.values.resize(surface.size(), number);
        number += 1;
    }
    Mesh mesh = std::move(surface).finish();
    mesh.attributes.push_back(std::move(faceIndex));
    return mesh;
}

namespace {

constexpr ShapeArgument kSoccerballArguments[] = {sizeArgument("radius", 1), fixedCount("cuts", 8, 1, 3)};

/// The middle of a hexagon is pushed out furthest, by 1/d, where d is its distance in radii. The small
/// triangles there have the side e / (d cuts), where e is the edge of the truncated icosahedron, and the
/// circumradius q. They lie 1 - sqrt(1 - q^2) <= q^2 / (1 + sqrt(1 - q^2)) inside. Measured, the pattern
/// moves by less than 2.2 times that.
double soccerballDeviation(Numbers n, Fidelity fidelity) {
    constexpr double kEdge = .403548, kDistance = .914958;
    const double circumradius = std::min(1., kEdge / (kDistance * n[1] * std::numbers::sqrt3));
    const double inside = 1 - std::sqrt(1 - circumradius * circumradius);
    return n[0] * inside * (fidelity == Fidelity::shape ? 1 : 2.2);
}

}  // namespace

constexpr PrimitiveSpec kSoccerballRow{.names = {"Soccerball"},
                                       .arguments = kSoccerballArguments,
                                       .summary = "sphere of 12 pentagons and 20 hexagons",
                                       .counts = [](Numbers n) { return soccerballCounts(countAt(n, 1)); },
                                       .make = [](Numbers n) { return soccerball(n[0], countAt(n, 1)); },
                                       .isClosed = true,
                                       .hasFaceIndex = true,
                                       .deviation = soccerballDeviation,
                                       .extent = [](Numbers n) { return ballExtent(n[0]); }};

}  // namespace glibra::geometry
