#include "geometry/shapes/flat.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/primitive.h"
#include "geometry/shapes/revolution.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

constexpr ShapeArgument kPlaneArguments[] = {sizeArgument("size", 1), numberArgument("s repeats", 1),
                                             numberArgument("t repeats", 1), countArgument("nx", 4, 1),
                                             countArgument("nz", 4, 1)};

}  // namespace

Mesh plane(double size, double sRepeats, double tRepeats, int nx, int nz) {
    assert(size >= 0 && nx >= 1 && nz >= 1);
    Surface surface(Topology::triangles, 2, planeCounts(nx, nz));
    for (int j = 0; j <= nz; ++j)
        for (int i = 0; i <= nx; ++i) {
            const double a = static_cast<double>(i) / nx, b = static_cast<double>(j) / nz;
            surface.add({.position = {(2 * a - 1) * size, 0, (1 - 2 * b) * size},
                         .normal = {0, 1, 0},
                         .tangent = {0, 0, tRepeats < 0 ? 1 : -1},
                         .texCoord = {sRepeats * a, tRepeats * b, 0}});
        }
    surface.gridCells(0, static_cast<std::uint32_t>(nx), static_cast<std::uint32_t>(nz));
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kPlaneRow{
    .names = {"Plane"},
    .arguments = kPlaneArguments,
    .summary = "square -size..size at y = 0 on which a texture repeats",
    .counts = [](Numbers n) { return planeCounts(countAt(n, 3), countAt(n, 4)); },
    .make = [](Numbers n) { return plane(n[0], n[1], n[2], countAt(n, 3), countAt(n, 4)); },
    .deviation = [](Numbers, Fidelity) { return 0.; },
    .extent = [](Numbers) { return Extent{}; }};

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
