#include "geometry/shapes/cylinders.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

Band cylinderSide(double radius, double height, int stacks) {
    return {.startRadius = radius, .endAlong = height, .endRadius = radius, .rows = stacks};
}

}  // namespace

Mesh cylinder(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    Surface surface(Topology::triangles, 2, cylinderCounts(slices, stacks));
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    const Band band = cylinderSide(radius, height, stacks);
    addBandPoints(surface, kStanding, band, circle);
    addBandCells(surface, 0, band, static_cast<std::uint32_t>(slices));
    addCap(surface, kStanding,
           {.along = height, .radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 0, -1}}, 1, circle);
    addCap(surface, kStanding, {.radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 0, 1}}, 1,
           circle);
    return std::move(surface).finish();
}

Mesh wireCylinder(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    Surface surface(Topology::lines, 2, wireCylinderCounts(slices, stacks));
    const Band band = cylinderSide(radius, height, stacks);
    addBandPoints(surface, kStanding, band, unitCircle(slices));
    addBandEdges(surface, band, static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kCylinderArguments[] = {sizeArgument("radius", 1), sizeArgument("height", 1),
                                                countArgument("slices", 60, 3, kSmoothTurn),
                                                countArgument("stacks", 20, 1)};
constexpr ShapeArgument kWireCylinderArguments[] = {sizeArgument("radius", 1), sizeArgument("height", 1),
                                                    countArgument("slices", 20, 3),
                                                    countArgument("stacks", 5, 1)};

double cylinderDeviation(Numbers n, Fidelity fidelity) {
    const double around = 2 * std::numbers::pi / n[2];
    return fidelity == Fidelity::shape ? chordDeviation(n[0], n[2]) : n[0] * around * around / 8;
}

}  // namespace

constexpr PrimitiveSpec kCylinderRow{
    .names = {"Cylinder"},
    .arguments = kCylinderArguments,
    .summary = "closed cylinder, base at y = 0",
    .counts = [](Numbers n) { return cylinderCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return cylinder(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .isClosed = true,
    .twin = &kWireCylinderRow,
    .deviation = cylinderDeviation,
    .extent = [](Numbers n) { return standingExtent(n[0], n[1]); }};

constexpr PrimitiveSpec kWireCylinderRow{
    .names = {"WireCylinder"},
    .arguments = kWireCylinderArguments,
    .summary = "cylinder as lines",
    .topology = Topology::lines,
    .counts = [](Numbers n) { return wireCylinderCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return wireCylinder(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .twin = &kCylinderRow};

namespace {

Band coneSide(double radius, double height, int stacks) {
    return {.startRadius = radius, .endAlong = height, .endRadius = 0, .rows = stacks, .apex = true};
}

}  // namespace

Mesh cone(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    Surface surface(Topology::triangles, 2, coneCounts(slices, stacks));
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    const Band band = coneSide(radius, height, stacks);
    addBandPoints(surface, kStanding, band, circle);
    addBandCells(surface, 0, band, static_cast<std::uint32_t>(slices));
    addCap(surface, kStanding, {.radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 0, 1}}, 1,
           circle);
    return std::move(surface).finish();
}

Mesh wireCone(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    Surface surface(Topology::lines, 2, wireConeCounts(slices, stacks));
    const Band band = coneSide(radius, height, stacks);
    addBandPoints(surface, kStanding, band, unitCircle(slices));
    addBandEdges(surface, band, static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kConeArguments[] = {sizeArgument("radius", 1), sizeArgument("height", 1),
                                            countArgument("slices", 60, 3, kSmoothTurn),
                                            countArgument("stacks", 20, 1)};
constexpr ShapeArgument kWireConeArguments[] = {sizeArgument("radius", 1), sizeArgument("height", 1),
                                                countArgument("slices", 20, 3),
                                                countArgument("stacks", 5, 1)};

double coneDeviation(Numbers n, Fidelity fidelity) {
    return coneSideDeviation(n[0], n[2], n[3], fidelity);
}

}  // namespace

constexpr PrimitiveSpec kConeRow{
    .names = {"Cone"},
    .arguments = kConeArguments,
    .summary = "closed cone, base at y = 0",
    .counts = [](Numbers n) { return coneCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return cone(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .isClosed = true,
    .twin = &kWireConeRow,
    .deviation = coneDeviation,
    .extent = [](Numbers n) { return standingExtent(n[0], n[1]); }};

constexpr PrimitiveSpec kWireConeRow{
    .names = {"WireCone"},
    .arguments = kWireConeArguments,
    .summary = "cone as lines",
    .topology = Topology::lines,
    .counts = [](Numbers n) { return wireConeCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return wireCone(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .twin = &kConeRow};

int xarrowShaftSlices(int slices) {
    return std::min(slices - 1, std::max(1, static_cast<int>(std::floor(.8 * slices + .5))));
}

Mesh xarrow(int slices, int sides) {
    assert(slices >= 2 && sides >= 3);
    constexpr double kTail = -1, kNeck = .6, kTip = 1, kShaftRadius = .05, kHeadRadius = .1;
    constexpr auto kT = [](double x) { return (x + 1) / 2; };
    const int onShaft = xarrowShaftSlices(slices);

    Surface surface(Topology::triangles, 2, xarrowCounts(slices, sides));
    const Axis pointing{.along = {1, 0, 0}, .zero = {0, 1, 0}, .quarter = {0, 0, 1}};
    const std::vector<glm::dvec2> circle = unitCircle(sides);
    const Band shaft{kTail, kShaftRadius, kT(kTail), kNeck, kShaftRadius, kT(kNeck), onShaft, false};
    const Band head{kNeck, kHeadRadius, kT(kNeck), kTip, 0, kT(kTip), slices - onShaft, true};
    for (const Band& band : {shaft, head}) {
        const std::uint32_t base = surface.size();
        addBandPoints(surface, pointing, band, circle);
        addBandCells(surface, base, band, static_cast<std::uint32_t>(sides));
    }
    const glm::dvec3 z{0, 0, 1}, y{0, 1, 0};
    addCap(surface, pointing, {.along = kTail, .radius = kShaftRadius, .sDirection = z, .tDirection = y}, 1,
           circle);
    addBackRing(surface, pointing, {.along = kNeck, .radius = kHeadRadius, .sDirection = z, .tDirection = y},
                kShaftRadius, circle);
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kXarrowArguments[] = {countArgument("slices", 100, 2),
                                              fixedCount("sides", 24, 3, 24)};

double xarrowDeviation(Numbers n, Fidelity fidelity) {
    const double onHead = n[0] - xarrowShaftSlices(countAt(n, 0));
    return coneSideDeviation(.1, n[1], onHead, fidelity);
}

}  // namespace

constexpr PrimitiveSpec kXarrowRow{
    .names = {"Xarrow"},
    .arguments = kXarrowArguments,
    .summary = "arrow along x",
    .counts = [](Numbers n) { return xarrowCounts(countAt(n, 0), countAt(n, 1)); },
    .make = [](Numbers n) { return xarrow(countAt(n, 0), countAt(n, 1)); },
    .isClosed = true,
    .deviation = xarrowDeviation,
    .extent = [](Numbers) { return boxExtent({-1, -.1, -.1}, {1, .1, .1}); }};

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
