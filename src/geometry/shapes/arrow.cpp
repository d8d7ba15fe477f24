#include "geometry/shapes/arrow.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
