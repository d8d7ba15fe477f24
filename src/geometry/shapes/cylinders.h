#pragma once
// Surfaces of revolution: cylinders, cones, arrows and tori.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

// Cylinders that stand on the plane y = 0, around the y axis.

constexpr Counts cylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1) + 4 * slices + 2, 2 * slices * stacks + 2 * slices);
}
constexpr Counts wireCylinderCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks + 1), slices * (2 * stacks + 1));
}

/// Makes a closed cylinder with its base at y = 0 and its top at y = height, as triangles that are
/// counter-clockwise seen from outside. radius, height >= 0, slices >= 3, stacks >= 1. On the side s runs
/// around the axis as on the sphere (0 on -x, .25 on +z) and t = y / height. On the caps s = .5 + x / 2R, and
/// t = .5 - z / 2R on top, .5 + z / 2R below. Order of the vertices: side, top, bottom. Size: cylinderCounts.
Mesh cylinder(double radius, double height, int slices, int stacks);

/// Makes the grid of the side as lines. Size: wireCylinderCounts.
Mesh wireCylinder(double radius, double height, int slices, int stacks);

extern const PrimitiveSpec kCylinderRow;
extern const PrimitiveSpec kWireCylinderRow;

// Cones that stand on the plane y = 0, around the y axis.

constexpr Counts coneCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * stacks + 3 * slices + 1, 2 * slices * stacks);
}
constexpr Counts wireConeCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * stacks + slices, 2 * slices * stacks);
}

/// Makes a closed cone with its base at y = 0 and its apex at y = height, as triangles that are
/// counter-clockwise seen from outside. radius, height >= 0, slices >= 3, stacks >= 1. On the side s runs
/// around the axis as on the sphere (0 on -x, .25 on +z), t = y / height, and normals are perpendicular to
/// the slant; the apex has one vertex per slice, with s and normal of the slice's middle. On the base s = .5
/// + x / 2R and t = .5 + z / 2R. Order of the vertices: side, base. Size: coneCounts.
Mesh cone(double radius, double height, int slices, int stacks);

/// Makes the grid of the side as lines. Size: wireConeCounts.
Mesh wireCone(double radius, double height, int slices, int stacks);

extern const PrimitiveSpec kConeRow;
extern const PrimitiveSpec kWireConeRow;

// The arrow along x. Existing shaders rely on its range.

constexpr Counts xarrowCounts(std::int64_t slices, std::int64_t sides = 24) {
    return detail::counted((sides + 1) * slices + 6 * sides + 4, 2 * sides * (slices + 1));
}

/// Makes a closed arrow around the x axis, as triangles that are counter-clockwise seen from outside. The
/// shaft has the radius .05 and goes from x = -1 to .6; the head narrows from the radius .1 at x = .6 to the
/// tip at x = 1. `slices` >= 2 cells along the arrow, about four fifths of them on the shaft; `sides` >= 3
/// around it (the language fixes 24). On shaft and head t = (x + 1) / 2 and s runs around the axis, 0 at +y,
/// .25 at +z. On the tail cap and on the back ring of the head s = .5 + z / 2R and t = .5 + y / 2R with their
/// outer radius R. Order of the vertices: shaft, head, tail cap, back ring. Size: xarrowCounts.
Mesh xarrow(int slices, int sides = 24);

/// The number of slices on the shaft.
int xarrowShaftSlices(int slices);

extern const PrimitiveSpec kXarrowRow;

// Tori around the z axis.

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
