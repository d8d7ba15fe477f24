#pragma once
// Squares parallel to the coordinate planes, and a stack of them.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles of a square -size..size, counter-clockwise seen from the positive axis; size >= 0, counts >= 1.
/// s and t run 0..1 over the square. At a negative coordinate only the texture frame turns, as if the square
/// faced the other way; normal, positions and triangles stay. Sizes: quadCounts.
///
/// In the plane z, nx by ny cells. Normal +z; t along +y; s along +x, for z < 0 along -x.
Mesh quadXY(double z, double size, int nx, int ny);
/// In the plane y, nx by nz cells. Normal +y; s along +x; t along -z, for y < 0 along +z.
Mesh quadXZ(double y, double size, int nx, int nz);
/// In the plane x, ny cells along y and nz along z. Normal +x; t along +y; s along -z, for x < 0 along +z.
Mesh quadYZ(double x, double size, int ny, int nz);

/// n >= 1 squares -1..1 parallel to XY at z = -1 + 2i/(n-1), in rising z (n = 1: z = 0). Triangles,
/// counter-clockwise seen from +z; normal +z, tangent +y, (s, t, p) = (P + 1) / 2. Sizes: quadBoxCounts.
Mesh quadBox(int n);

}  // namespace glibra::geometry
