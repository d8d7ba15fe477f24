#pragma once
// The upper half of a sphere, closed by a disk in the plane y = 0.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts halfSphereCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * stacks + 3 * slices + 1, 2 * slices * stacks);
}

/// Makes the closed half y >= 0 of the sphere about the origin, as triangles that are counter-clockwise seen
/// from outside. radius >= 0, slices >= 3 around the y axis, stacks >= 1 from the equator to the pole. On the
/// dome, with the latitude f = pi/2 t: P = radius (-cos 2 pi s cos f, sin f, sin 2 pi s cos f), so s is 0 on
/// -x and .25 on +z as on the sphere, and t is 0 at the equator and 1 at the pole; the pole has one vertex
/// per slice, with s in the slice's middle. On the disk, which faces down, s = .5 + x / 2R and t = .5 + z /
/// 2R. Order of the vertices: dome, disk. Size: halfSphereCounts.
Mesh halfSphere(double radius, int slices, int stacks);

extern const PrimitiveSpec kHalfSphereRow;

}  // namespace glibra::geometry
