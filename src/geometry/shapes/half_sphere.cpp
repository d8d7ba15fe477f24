#include "geometry/shapes/half_sphere.h"

#include <cassert>
#include <numbers>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/deviation.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {
namespace {

SurfacePoint domePoint(double radius, const glm::dvec2& around, const glm::dvec2& latitude, double s,
                       double t) {
    const double c = latitude.x, y = latitude.y;
    const glm::dvec3 normal{-around.x * c, y, around.y * c};
    return {.position = radius * normal,
            .normal = normal,
            .tangent = {around.x * y, c, -around.y * y},
            .texCoord = {s, t, 0}};
}

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
        for (int i = 0; i <= slices; ++i)
            surface.add(domePoint(radius, circle[static_cast<std::size_t>(i)],
                                  unitTurn(j, 4 * std::int64_t{stacks}), static_cast<double>(i) / slices,
                                  static_cast<double>(j) / stacks));
    const std::uint32_t pole = surface.size();
    for (int i = 0; i < slices; ++i)
        surface.add(domePoint(radius, unitTurn(2 * std::int64_t{i} + 1, 2 * std::int64_t{slices}), {0, 1},
                              (i + .5) / slices, 1));
    const auto a = static_cast<std::uint32_t>(slices);
    const std::uint32_t lastRing = pole - (a + 1);
    surface.gridCells(0, a, static_cast<std::uint32_t>(stacks) - 1);
    for (std::uint32_t i = 0; i < a; ++i) surface.triangle(lastRing + i, lastRing + i + 1, pole + i);
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
