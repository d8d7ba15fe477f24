#pragma once
// Grids of points in the cube -1..1.

#include <cstdint>

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

/// For pointCloud and jitterCloud.
constexpr Counts cloudCounts(std::int64_t nx, std::int64_t ny, std::int64_t nz) {
    return detail::counted(nx * ny * nz, nx * ny * nz);
}

/// Makes points at -1 + 2i/(n-1) along each axis (at 0 for n = 1); the counts are at least 1. Order: x
/// fastest, then y, then z. Normal (0, 0, 1), texture coordinates (s, t, p) = (P + 1) / 2. Size: cloudCounts.
Mesh pointCloud(int nx, int ny, int nz);

/// Makes the same points in the same order and displaces each along every axis by up to half a cell. A point
/// that would leave the cube is reflected at its border. The displacement is a hash of the seed and the
/// point's number (`mix`), so it is the same on every machine.
Mesh jitterCloud(int nx, int ny, int nz, std::uint32_t seed);

extern const PrimitiveSpec kPointCloudRow;
extern const PrimitiveSpec kJitterCloudRow;

}  // namespace glibra::geometry
