#pragma once
// Boxes about the origin.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed; side lengths >= 0. Six faces with their own vertices, s
/// and t 0..1 on each, in this order (direction of s, of t): +x (-z, +y); -x (+z, +y); +y (+x, -z); -y (+x,
/// +z); +z (+x, +y); -z (-x, +y). Sizes: boxCounts.
Mesh box(double dx, double dy, double dz);

/// The twelve edges as lines on eight corners: x fastest, then y, then z; normals along the box's diagonals,
/// s, t, p 0 or 1 with x, y, z, tangent T0(N). Sizes: wireBoxCounts.
Mesh wireBox(double dx, double dy, double dz);

}  // namespace glibra::geometry
