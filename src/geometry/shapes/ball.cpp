#include "geometry/shapes/ball.h"

#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

SurfacePoint ballPoint(double radius, const BallRing& ring, const glm::dvec2& around, double s) {
    const double c = ring.latitude.x, y = ring.latitude.y;
    const glm::dvec3 normal{-around.x * c, y, around.y * c};
    return {.position = radius * normal + glm::dvec3(0, ring.centre, 0),
            .normal = normal,
            .tangent = {around.x * y, c, -around.y * y},
            .texCoord = {s, ring.t, 0}};
}

}  // namespace

void addBallRing(Surface& surface, double radius, const BallRing& ring, std::span<const glm::dvec2> circle) {
    const auto slices = static_cast<double>(circle.size() - 1);
    for (std::size_t i = 0; i < circle.size(); ++i)
        surface.add(ballPoint(radius, ring, circle[i], static_cast<double>(i) / slices));
}

void addBallPole(Surface& surface, double radius, const BallRing& pole, int slices) {
    for (int i = 0; i < slices; ++i)
        surface.add(ballPoint(radius, pole, unitTurn(2 * std::int64_t{i} + 1, 2 * std::int64_t{slices}),
                              (i + .5) / slices));
}

void addBallCells(Surface& surface, std::uint32_t rings, std::uint32_t slices) {
    const std::uint32_t lastRing = slices + (rings - 1) * (slices + 1);
    for (std::uint32_t i = 0; i < slices; ++i) surface.triangle(i, slices + i + 1, slices + i);
    surface.gridCells(slices, slices, rings - 1);
    addNorthCells(surface, lastRing, lastRing + slices + 1, slices);
}

void addNorthCells(Surface& surface, std::uint32_t ring, std::uint32_t pole, std::uint32_t slices) {
    for (std::uint32_t i = 0; i < slices; ++i) surface.triangle(ring + i, ring + i + 1, pole + i);
}

}  // namespace glibra::geometry
