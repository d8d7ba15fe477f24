#include "geometry/shapes/capsule.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/deviation.h"

namespace glibra::geometry {
namespace {

constexpr ShapeArgument kCapsuleArguments[] = {sizeArgument("radius", .5), sizeArgument("height", 1),
                                               countArgument("slices", 60, 3, kSmoothTurn),
                                               countArgument("stacks", 20, 1, kSmoothTurn / 4)};

/// The half spheres are off by more than the cylinder.
double capsuleDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[2], std::numbers::pi / 2 / n[3], fidelity);
}

Extent capsuleExtent(Numbers n) {
    const double end = n[0] + n[1] / 2;
    return {{-n[0], -end, -n[0]}, {n[0], end, n[0]}, end};
}

}  // namespace

Mesh capsule(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    const double quarter = std::numbers::pi / 2 * radius, length = 2 * quarter + height;
    const auto t = [&](double along) { return length > 0 ? along / length : 0; };
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    Surface surface(Topology::triangles, 2, capsuleCounts(slices, stacks));
    addBallPole(surface, radius, {{0, -1}, 0, -height / 2}, slices);
    for (int half = 0; half < 2; ++half)
        for (int j = 0; j < stacks; ++j) {
            // Counted from the pole in the south, from the equator in the north.
            const int row = half == 0 ? j + 1 : j;
            const glm::dvec2 turn = unitTurn(row, 4 * std::int64_t{stacks});
            const double part = static_cast<double>(row) / stacks;
            const BallRing ring = half == 0
                                      ? BallRing{{turn.y, -turn.x}, t(quarter * part), -height / 2}
                                      : BallRing{turn, t(quarter + height + quarter * part), height / 2};
            addBallRing(surface, radius, ring, circle);
        }
    addBallPole(surface, radius, {{0, 1}, 1, height / 2}, slices);
    addBallCells(surface, 2 * static_cast<std::uint32_t>(stacks), static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

constexpr PrimitiveSpec kCapsuleRow{
    .names = {"Capsule"},
    .arguments = kCapsuleArguments,
    .summary = "cylinder with a half sphere at each end, centred; height is the cylinder's",
    .counts = [](Numbers n) { return capsuleCounts(countAt(n, 2), countAt(n, 3)); },
    .make = [](Numbers n) { return capsule(n[0], n[1], countAt(n, 2), countAt(n, 3)); },
    .isClosed = true,
    .deviation = capsuleDeviation,
    .extent = capsuleExtent};

}  // namespace glibra::geometry
