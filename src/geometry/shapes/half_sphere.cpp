#include "geometry/shapes/half_sphere.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {
namespace {

constexpr ShapeArgument kHalfSphereArguments[] = {sizeArgument("radius", 1),
                                                  countArgument("slices", 60, 3, kSmoothTurn),
                                                  countArgument("stacks", 30, 1, kSmoothTurn / 4)};

double halfSphereDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[1], std::numbers::pi / 2 / n[2], fidelity);
}

}  // namespace

Mesh halfSphere(double radius, int slices, int stacks) {
    assert(radius >= 0 && slices >= 3 && stacks >= 1);
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    Surface surface(Topology::triangles, 2, halfSphereCounts(slices, stacks));
    for (int j = 0; j < stacks; ++j)
        addBallRing(surface, radius, {unitTurn(j, 4 * std::int64_t{stacks}), static_cast<double>(j) / stacks},
                    circle);
    const std::uint32_t pole = surface.size();
    addBallPole(surface, radius, {{0, 1}, 1}, slices);
    const auto a = static_cast<std::uint32_t>(slices);
    surface.gridCells(0, a, static_cast<std::uint32_t>(stacks) - 1);
    addNorthCells(surface, pole - (a + 1), pole, a);
    addCap(surface, kStanding, {.radius = radius, .sDirection = {1, 0, 0}, .tDirection = {0, 0, 1}}, 1,
           circle);
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kHalfSphereRow{
    .names = {"HalfSphere"},
    .arguments = kHalfSphereArguments,
    .summary = "upper half of a sphere, closed by a disk at y = 0",
    .counts = [](Numbers n) { return halfSphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return halfSphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .isClosed = true,
    .deviation = halfSphereDeviation,
    .extent = [](Numbers n) { return standingExtent(n[0], n[0]); }};

}  // namespace glibra::geometry
