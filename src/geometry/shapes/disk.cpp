#include "geometry/shapes/disk.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {

Mesh diskXY(double z, double radius, int slices, int rings) {
    assert(radius >= 0 && slices >= 3 && rings >= 1);
    Surface surface(Topology::triangles, 2, diskXYCounts(slices, rings));
    const Axis facing{.along = {0, 0, 1}, .zero = {1, 0, 0}, .quarter = {0, 1, 0}};
    addCap(surface, facing, {.along = z, .radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 1, 0}},
           rings, unitCircle(slices));
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kDiskArguments[] = {numberArgument("z", 0), sizeArgument("radius", 1),
                                            countArgument("slices", 60, 3, kSmoothTurn),
                                            countArgument("rings", 10, 1)};

}  // namespace

constexpr PrimitiveSpec kDiskXYRow{
    .names = {"DiskXY"},
    .arguments = kDiskArguments,
    .summary = "disk parallel to XY",
    .counts = [](Numbers n) { return diskXYCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return diskXY(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    // s and t are linear in x and y, so only the rim is off.
    .deviation = [](Numbers n, Fidelity) { return chordDeviation(n[1], n[2]); },
    .extent = [](Numbers n) { return boxExtent({-n[1], -n[1], n[0]}, {n[1], n[1], n[0]}); }};

}  // namespace glibra::geometry
