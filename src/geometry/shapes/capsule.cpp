#include "geometry/shapes/capsule.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

/// One ring, or one pole, of the profile.
struct Ring {
    double centre = 0;          ///< y of the half sphere's centre
    glm::dvec2 latitude{1, 0};  ///< (cos f, sin f)
    double t = 0;
};

SurfacePoint capsulePoint(double radius, const Ring& ring, const glm::dvec2& around, double s) {
    const double c = ring.latitude.x, y = ring.latitude.y;
    const glm::dvec3 normal{-around.x * c, y, around.y * c};
    return {.position = radius * normal + glm::dvec3(0, ring.centre, 0),
            .normal = normal,
            .tangent = {around.x * y, c, -around.y * y},
            .texCoord = {s, ring.t, 0}};
}

void addCapsulePole(Surface& surface, double radius, const Ring& pole, int slices) {
    for (int i = 0; i < slices; ++i)
        surface.add(capsulePoint(radius, pole, unitTurn(2 * std::int64_t{i} + 1, 2 * std::int64_t{slices}),
                                 (i + .5) / slices));
}

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
    addCapsulePole(surface, radius, {-height / 2, {0, -1}, 0}, slices);
    for (int half = 0; half < 2; ++half)
        for (int j = 0; j < stacks; ++j) {
            // Counted from the pole in the south, from the equator in the north.
            const int row = half == 0 ? j + 1 : j;
            const glm::dvec2 turn = unitTurn(row, 4 * std::int64_t{stacks});
            const double part = static_cast<double>(row) / stacks;
            const Ring ring = half == 0 ? Ring{-height / 2, {turn.y, -turn.x}, t(quarter * part)}
                                        : Ring{height / 2, turn, t(quarter + height + quarter * part)};
            for (int i = 0; i <= slices; ++i)
                surface.add(capsulePoint(radius, ring, circle[static_cast<std::size_t>(i)],
                                         static_cast<double>(i) / slices));
        }
    addCapsulePole(surface, radius, {height / 2, {0, 1}, 1}, slices);

    const auto a = static_cast<std::uint32_t>(slices);
    const std::uint32_t rows = 2 * static_cast<std::uint32_t>(stacks) - 1;
    const std::uint32_t lastRing = a + rows * (a + 1), north = lastRing + a + 1;
    for (std::uint32_t i = 0; i < a; ++i) surface.triangle(i, a + i + 1, a + i);
    surface.gridCells(a, a, rows);
    for (std::uint32_t i = 0; i < a; ++i) surface.triangle(lastRing + i, lastRing + i + 1, north + i);
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
