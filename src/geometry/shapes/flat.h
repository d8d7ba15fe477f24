#pragma once
// Shapes in a plane.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

// The ground: a square in the plane y = 0 on which a texture repeats.

constexpr Counts planeCounts(std::int64_t nx, std::int64_t nz) {
    return detail::counted((nx + 1) * (nz + 1), 2 * nx * nz);
}

/// Makes the square -size..size of the plane y = 0, nx by nz cells, as triangles that are counter-clockwise
/// seen from above. size >= 0, counts >= 1. Normal +y. A texture repeats sRepeats times along +x and tRepeats
/// times along -z: s = sRepeats (x + size) / 2 size, t = tRepeats (size - z) / 2 size. A negative number of
/// repeats mirrors the texture, and the tangent points along rising t (-z, or +z for tRepeats < 0). Rows run
/// with falling z, x fastest. Size: planeCounts.
Mesh plane(double size, double sRepeats, double tRepeats, int nx, int nz);

extern const PrimitiveSpec kPlaneRow;

// A flat disk parallel to the plane XY.

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
