#pragma once
// A flat disk parallel to the plane XY.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts diskXYCounts(std::int64_t slices, std::int64_t rings) {
    return detail::counted((slices + 1) * rings + slices, slices * (2 * rings - 1));
}

/// Makes a disk in the plane of that z, with its centre on the z axis, as triangles that are
/// counter-clockwise seen from +z. radius >= 0, slices >= 3, rings >= 1 at equal steps of the radius. Normal
/// +z, s = .5 + x / 2R, t = .5 + y / 2R. The first slice begins at +x; the centre has one vertex per slice.
/// Order of the vertices: from the centre outward. Size: diskXYCounts.
Mesh diskXY(double z, double radius, int slices, int rings);

extern const PrimitiveSpec kDiskXYRow;

}  // namespace glibra::geometry
