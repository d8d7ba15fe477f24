#pragma once
// Shapes in a plane: grounds, disks, and squares parallel to the coordinate planes.

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

// Squares parallel to the coordinate planes, and a stack of them.

/// For quadXY, quadXZ and quadYZ.
constexpr Counts quadCounts(std::int64_t n1, std::int64_t n2) {
    return detail::counted((n1 + 1) * (n2 + 1), 2 * n1 * n2);
}
constexpr Counts quadBoxCounts(std::int64_t n) {
    return detail::counted(4 * n, 2 * n);
}

/// Each of the next three makes a square -size..size, as triangles that are counter-clockwise seen from the
/// positive axis. size >= 0, counts >= 1. s and t run from 0 to 1 over the square. At a negative coordinate
/// only the directions of s and t change, as if the square faced the other way; normal, positions and
/// triangles stay. Size: quadCounts.
///
/// In the plane z, nx by ny cells. Normal +z; t along +y; s along +x, or for z < 0 along -x.
Mesh quadXY(double z, double size, int nx, int ny);
/// In the plane y, nx by nz cells. Normal +y; s along +x; t along -z, or for y < 0 along +z.
Mesh quadXZ(double y, double size, int nx, int nz);
/// In the plane x, ny cells along y and nz along z. Normal +x; t along +y; s along -z, or for x < 0 along +z.
Mesh quadYZ(double x, double size, int ny, int nz);

/// Makes n >= 1 squares -1..1 parallel to XY at z = -1 + 2i/(n-1), from the lowest z up (at z = 0 for n = 1),
/// as triangles that are counter-clockwise seen from +z. Normal +z, tangent +y, (s, t, p) = (P + 1) / 2.
/// Size: quadBoxCounts.
Mesh quadBox(int n);

extern const PrimitiveSpec kQuadXYRow;
extern const PrimitiveSpec kQuadXZRow;
extern const PrimitiveSpec kQuadYZRow;
extern const PrimitiveSpec kQuadBoxRow;
/// quadXY(0, 1, 1, 1): positions are clip coordinates with z = 0, w = 1.
extern const PrimitiveSpec kFullScreenRow;

}  // namespace glibra::geometry
