#include "geometry/shapes/cylinder.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

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
    addBandEdges(surface, 0, band, static_cast<std::uint32_t>(slices));
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

}  // namespace glibra::geometry
