#pragma once
// A flat disk parallel to the plane XY.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise seen from +z, in the plane of that z, centre on the z axis. radius >= 0,
/// slices >= 3, rings >= 1 at equal steps of the radius. Normal +z, s = .5 + x / 2R, t = .5 + y / 2R. The
/// first slice begins at +x; the centre holds one vertex a slice. From the centre outward. Sizes:
/// diskXYCounts.
Mesh diskXY(double z, double radius, int slices, int rings);

}  // namespace glibra::geometry
