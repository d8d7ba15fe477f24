#include "geometry/shapes/torus.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

void addPoints(Surface& surface, double a, double b, int sides, int rings) {
    assert(a >= 0 && b >= 0 && sides >= 3 && rings >= 3);
    const double ring = std::max(a, b), tube = std::min(a, b);
    const std::vector<glm::dvec2> around = unitCircle(sides), along = unitCircle(rings);
    for (int j = 0; j <= sides; ++j)
        for (int i = 0; i <= rings; ++i) {
            const glm::dvec2 u = along[static_cast<std::size_t>(i)], v = around[static_cast<std::size_t>(j)];
            const double distance = ring + tube * v.x;
            surface.add({.position = {distance * u.x, distance * u.y, tube * v.y},
                         .normal = {v.x * u.x, v.x * u.y, v.y},
                         .tangent = {-v.y * u.x, -v.y * u.y, v.x},
                         .texCoord = {static_cast<double>(i) / rings, static_cast<double>(j) / sides, 0}});
        }
}

}  // namespace

Mesh torus(double a, double b, int sides, int rings) {
    Surface surface(Topology::triangles, 2, torusCounts(sides, rings));
    addPoints(surface, a, b, sides, rings);
    surface.gridCells(0, static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(sides));
    return std::move(surface).finish();
}

Mesh wireTorus(double a, double b, int sides, int rings) {
    Surface surface(Topology::lines, 2, wireTorusCounts(sides, rings));
    addPoints(surface, a, b, sides, rings);
    const auto columns = static_cast<std::uint32_t>(rings), rows = static_cast<std::uint32_t>(sides);
    addGridEdges(surface, 0, {.columns = columns, .rows = rows, .endRow = rows, .endColumn = columns});
    return std::move(surface).finish();
}

}  // namespace glibra::geometry
