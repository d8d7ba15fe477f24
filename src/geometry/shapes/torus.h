#pragma once
// Tori around the z axis.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts torusCounts(std::int64_t sides, std::int64_t rings) {
    return detail::counted((rings + 1) * (sides + 1), 2 * rings * sides);
}
constexpr Counts wireTorusCounts(std::int64_t sides, std::int64_t rings) {
    return torusCounts(sides, rings);
}

/// Makes a closed torus with its ring in the plane XY, as triangles that are counter-clockwise seen from
/// outside. The larger of a, b >= 0 is the radius R of the ring, the smaller one the radius r of the tube;
/// sides >= 3 around the tube, rings >= 3 along it. With u = 2 pi s, v = 2 pi t: P = ((R + r cos v) cos u,
/// (R + r cos v) sin u, r sin v). Rows run with rising t, s fastest. Size: torusCounts.
Mesh torus(double a, double b, int sides, int rings);

/// Makes the same grid as lines. Size: wireTorusCounts.
Mesh wireTorus(double a, double b, int sides, int rings);

extern const PrimitiveSpec kTorusRow;
extern const PrimitiveSpec kWireTorusRow;

}  // namespace glibra::geometry
