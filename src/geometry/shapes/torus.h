#pragma once
// Tori around the z axis.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed, the ring in the plane XY. The larger of a, b >= 0 is
/// the radius R of the ring, the smaller the radius r of the tube; sides >= 3 around the tube, rings >= 3
/// along it. With u = 2 pi s, v = 2 pi t: P = ((R + r cos v) cos u, (R + r cos v) sin u, r sin v). Rows of
/// rising t, s fastest. Sizes: torusCounts.
Mesh torus(double a, double b, int sides, int rings);

/// The same grid as lines. Sizes: wireTorusCounts.
Mesh wireTorus(double a, double b, int sides, int rings);

}  // namespace glibra::geometry
