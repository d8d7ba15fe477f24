#pragma once
// The arrow along x. Existing shaders rely on its range.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
