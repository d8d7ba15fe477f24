#include "geometry/shapes/cylinder.h"

#include <cassert>
#include <utility>

#include "geometry/frame.h"
#include "geometry/shapes/revolution.h"

namespace glibra::geometry {
namespace {

const Axis kStanding{.along = {0, 1, 0}, .zero = {-1, 0, 0}, .quarter = {0, 0, 1}};

Band side(double radius, double height, int stacks) {
    return {.startRadius = radius, .endAlong = height, .endRadius = radius, .rows = stacks};
}

}  // namespace

Mesh cylinder(double radius, double height, int slices, int stacks) {
    assert(radius >= 0 && height >= 0 && slices >= 3 && stacks >= 1);
    Surface surface(Topology::triangles, 2, cylinderCounts(slices, stacks));
    const std::vector<glm::dvec2> circle = unitCircle(slices);
    const Band band = side(radius, height, stacks);
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
    const Band band = side(radius, height, stacks);
    addBandPoints(surface, kStanding, band, unitCircle(slices));
    addBandEdges(surface, 0, band, static_cast<std::uint32_t>(slices));
    return std::move(surface).finish();
}

}  // namespace glibra::geometry
