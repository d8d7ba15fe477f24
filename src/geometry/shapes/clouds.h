#pragma once
// Grids of points in the cube -1..1.

#include <cstdint>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Points at -1 + 2i/(n-1) along each axis (n = 1: 0), counts >= 1; x fastest, then y, then z. Normal (0, 0,
/// 1), (s, t, p) = (P + 1) / 2. Sizes: cloudCounts.
Mesh pointCloud(int nx, int ny, int nz);

/// The same points in the same order, each displaced along every axis by up to half a cell; a point that
/// leaves the cube is reflected at its border. The displacement is a hash of the seed and the point's number
/// (`mix`): the same on every machine.
Mesh jitterCloud(int nx, int ny, int nz, std::uint32_t seed);

}  // namespace glibra::geometry
