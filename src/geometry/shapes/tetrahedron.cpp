#include "geometry/shapes/tetrahedron.h"

#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
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

}  // namespace glibra::geometry
