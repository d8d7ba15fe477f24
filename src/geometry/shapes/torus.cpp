#include "geometry/shapes/torus.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

void addTorusPoints(Surface& surface, double a, double b, int sides, int rings) {
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
    addTorusPoints(surface, a, b, sides, rings);
    surface.gridCells(0, static_cast<std::uint32_t>(rings), static_cast<std::uint32_t>(sides));
    return std::move(surface).finish();
}

Mesh wireTorus(double a, double b, int sides, int rings) {
    Surface surface(Topology::lines, 2, wireTorusCounts(sides, rings));
    addTorusPoints(surface, a, b, sides, rings);
    const auto columns = static_cast<std::uint32_t>(rings), rows = static_cast<std::uint32_t>(sides);
    addGridEdges(surface, 0, {.columns = columns, .rows = rows, .endRow = rows, .endColumn = columns});
    return std::move(surface).finish();
}

namespace {

/// The 20 sides by default are fewer than a smooth turn; 36 would be more than the language asks for.
constexpr ShapeArgument kTorusArguments[] = {sizeArgument("radius", 1), sizeArgument("radius", .5),
                                             countArgument("sides", 20, 3, 20),
                                             countArgument("rings", 40, 3, kSmoothTurn)};

double torusDeviation(Numbers n, Fidelity fidelity) {
    const double ring = std::max(n[0], n[1]), tube = std::min(n[0], n[1]);
    if (fidelity == Fidelity::shape) return chordDeviation(tube, n[2]) + chordDeviation(ring + tube, n[3]);
    // |P_uu| = R + r cos v, |P_uv| = r |sin v|, |P_vv| = r: the largest sum over v.
    const double u = 2 * std::numbers::pi / n[3], v = 2 * std::numbers::pi / n[2];
    return (ring * u * u + tube * v * v + std::hypot(tube * u * u, 2 * tube * u * v)) / 8;
}

Extent torusExtent(Numbers n) {
    const double tube = std::min(n[0], n[1]), all = n[0] + n[1];
    return {{-all, -all, -tube}, {all, all, tube}, all};
}

}  // namespace

constexpr PrimitiveSpec kTorusRow{
    .names = {"Torus"},
    .arguments = kTorusArguments,
    .summary = "torus about the z axis; the larger radius is the ring's",
    .counts = [](Numbers n) { return torusCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return torus(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .isClosed = true,
    .twin = &kWireTorusRow,
    .deviation = torusDeviation,
    .extent = torusExtent};

constexpr PrimitiveSpec kWireTorusRow{
    .names = {"WireTorus"},
    .arguments = kTorusArguments,
    .summary = "torus as lines",
    .topology = Topology::lines,
    .counts = [](Numbers n) { return wireTorusCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return wireTorus(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .twin = &kTorusRow};

}  // namespace glibra::geometry
