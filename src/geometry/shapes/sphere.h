#pragma once
// Spheres about the origin, poles on the y axis.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed. radius >= 0, slices >= 3 around the axis, stacks >= 2
/// from pole to pole. With f = pi (t - 1/2): P = radius (-cos 2 pi s cos f, sin f, sin 2 pi s cos f), so s =
/// 0 and 1 lie on -x, s = .25 on +z; t = 0 is the south pole. Rows run from south to north, s fastest; the
/// poles hold one vertex a slice, with s in the middle of the slice. Sizes: sphereCounts.
Mesh sphere(double radius, int slices, int stacks);

/// Meridians and parallels as lines, each once, on the vertices of `sphere`. Sizes: wireSphereCounts.
Mesh wireSphere(double radius, int slices, int stacks);

}  // namespace glibra::geometry
