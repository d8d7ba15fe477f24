#pragma once
// Cylinders that stand on the plane y = 0, around the y axis.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts cylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1) + 4 * slices + 2, 2 * slices * stacks + 2 * slices);
}
constexpr Counts wireCylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1), slices * (2 * stacks + 1));
}

/// Makes a closed cylinder with its base at y = 0 and its top at y = height, as triangles that are
/// counter-clockwise seen from outside. radius, height >= 0, slices >= 3, stacks >= 1. On the side s runs
/// around the axis as on the sphere (0 on -x, .25 on +z) and t = y / height. On the caps s = .5 + x / 2R, and
/// t = .5 - z / 2R on top, .5 + z / 2R below. Order of the vertices: side, top, bottom. Size: cylinderCounts.
Mesh cylinder(double radius, double height, int slices, int stacks);

/// Makes the grid of the side as lines. Size: wireCylinderCounts.
Mesh wireCylinder(double radius, double height, int slices, int stacks);

extern const PrimitiveSpec kCylinderRow;
extern const PrimitiveSpec kWireCylinderRow;

}  // namespace glibra::geometry
