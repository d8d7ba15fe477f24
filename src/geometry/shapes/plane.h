#pragma once
// The ground: a square in the plane y = 0 on which a texture repeats.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
