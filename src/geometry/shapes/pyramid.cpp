#include "geometry/shapes/pyramid.h"

#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
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

}  // namespace glibra::geometry
