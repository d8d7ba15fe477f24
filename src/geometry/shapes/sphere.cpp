#include "geometry/shapes/sphere.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/ball.h"
#include "geometry/shapes/deviation.h"

namespace glibra::geometry {
namespace {

void addSpherePoints(Surface& surface, double radius, int slices, int stacks) {
    assert(radius >= 0 && slices >= 3 && stacks >= 2);
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    addBallPole(surface, radius, {{0, -1}, 0}, slices);
    for (int j = 1; j < stacks; ++j) {
        const glm::dvec2 colatitude = unitTurn(j, 2 * std::int64_t{stacks});  // from the south pole
        addBallRing(surface, radius, {{colatitude.y, -colatitude.x}, static_cast<double>(j) / stacks},
                    circle);
    }
    addBallPole(surface, radius, {{0, 1}, 1}, slices);
}

}  // namespace

Mesh sphere(double radius, int slices, int stacks) {
    Surface surface(Topology::triangles, 2, sphereCounts(slices, stacks));
    addSpherePoints(surface, radius, slices, stacks);
    addBallCells(surface, static_cast<std::uint32_t>(stacks) - 1, static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

Mesh wireSphere(double radius, int slices, int stacks) {
    Surface surface(Topology::lines, 2, wireSphereCounts(slices, stacks));
    addSpherePoints(surface, radius, slices, stacks);
    const auto a = static_cast<std::uint32_t>(slices), b = static_cast<std::uint32_t>(stacks);
    const std::uint32_t lastRing = a + (b - 2) * (a + 1), north = lastRing + a + 1;
    for (std::uint32_t i = 0; i < a; ++i) surface.segment(i, a + i);
    addGridEdges(surface, a, {.columns = a, .rows = b - 2, .endRow = b - 1, .endColumn = a});
    for (std::uint32_t i = 0; i < a; ++i) surface.segment(lastRing + i, north + i);
    return std::move(surface).finish();
}

namespace {

constexpr ShapeArgument kSphereArguments[] = {sizeArgument("radius", 1),
                                              countArgument("slices", 60, 3, kSmoothTurn),
                                              countArgument("stacks", 60, 2, kSmoothTurn / 2)};
constexpr ShapeArgument kWireSphereArguments[] = {sizeArgument("radius", 1), countArgument("slices", 20, 3),
                                                  countArgument("stacks", 20, 2)};

double sphereDeviation(Numbers n, Fidelity fidelity) {
    return ballDeviation(n[0], 2 * std::numbers::pi / n[1], std::numbers::pi / n[2], fidelity);
}

}  // namespace

constexpr PrimitiveSpec kSphereRow{
    .names = {"Sphere"},
    .arguments = kSphereArguments,
    .summary = "sphere, poles on the y axis",
    .counts = [](Numbers n) { return sphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return sphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .isClosed = true,
    .twin = &kWireSphereRow,
    .deviation = sphereDeviation,
    .extent = [](Numbers n) { return ballExtent(n[0]); }};

constexpr PrimitiveSpec kWireSphereRow{
    .names = {"WireSphere"},
    .arguments = kWireSphereArguments,
    .summary = "sphere as lines",
    .topology = Topology::lines,
    .counts = [](Numbers n) { return wireSphereCounts(countAt(n, 1), countAt(n, 2)); },
    .make = [](Numbers n) { return wireSphere(n[0], countAt(n, 1), countAt(n, 2)); },
    .twin = &kSphereRow};

}  // namespace glibra::geometry
