#include "geometry/shapes/soccerball.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
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
