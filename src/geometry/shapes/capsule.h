#pragma once
// Capsules about the origin: a cylinder around the y axis with a half sphere at each end.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts capsuleCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted(2 * (slices + 1) * stacks + 2 * slices, 4 * slices * stacks);
}

/// Makes the closed surface of all points at the distance `radius` from the segment between (0, -height/2, 0)
/// and (0, height/2, 0), as triangles that are counter-clockwise seen from outside. radius, height >= 0,
/// slices >= 3 around the axis, stacks >= 1 on each half sphere; the cylinder between them is one row.
///
/// s runs around the axis as on the sphere (0 on -x, .25 on +z). t is the length along the profile from the
/// south pole, divided by its whole length pi radius + height, so a pattern is not stretched where cylinder
/// and half spheres meet. With the latitude f on a half sphere: P = (-radius cos 2 pi s cos f, radius sin f
/// +- height/2, radius sin 2 pi s cos f). Rows run from south to north, s fastest; each pole has one vertex
/// per slice, with s in the slice's middle. Size: capsuleCounts.
Mesh capsule(double radius, double height, int slices, int stacks);

extern const PrimitiveSpec kCapsuleRow;

}  // namespace glibra::geometry
