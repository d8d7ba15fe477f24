#include "geometry/shapes/cone.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {
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
    addBandEdges(surface, 0, band, static_cast<std::uint32_t>(slices));
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

}  // namespace glibra::geometry
