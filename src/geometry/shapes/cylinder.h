#pragma once
// Cylinders that stand on the plane y = 0, around the y axis.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed: base at y = 0, top at y = height. radius, height >= 0,
/// slices >= 3, stacks >= 1. Side: s around as on the sphere (0 on -x, .25 on +z), t = y / height. Caps: s =
/// .5 + x / 2R, t = .5 - z / 2R on top and .5 + z / 2R below. In this order: side, top, bottom. Sizes:
/// cylinderCounts.
Mesh cylinder(double radius, double height, int slices, int stacks);

/// The side's grid as lines. Sizes: wireCylinderCounts.
Mesh wireCylinder(double radius, double height, int slices, int stacks);

}  // namespace glibra::geometry
