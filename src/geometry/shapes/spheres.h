#pragma once
// Solids that are made of spheres.

#include <glm/vec2.hpp>
#include <span>

#include "geometry/shapes/primitive.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {

// Spheres about the origin, with the poles on the y axis.

constexpr Counts sphereCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks - 1) + 2 * slices, 2 * slices * (stacks - 1));
}
constexpr Counts wireSphereCounts(std::int64_t slices, std::int64_t stacks) {
    return detail::counted((slices + 1) * (stacks - 1) + 2 * slices, slices * (2 * stacks - 1));
}

/// Makes a closed sphere, as triangles that are counter-clockwise seen from outside. radius >= 0, slices >= 3
/// around the axis, stacks >= 2 from pole to pole. With f = pi (t - 1/2): P = radius (-cos 2 pi s cos f, sin
/// f, sin 2 pi s cos f), so s = 0 and 1 lie on -x, s = .25 lies on +z, and t = 0 is the south pole. Rows run
/// from south to north, s fastest; each pole has one vertex per slice, with s in the slice's middle. Size:
/// sphereCounts.
Mesh sphere(double radius, int slices, int stacks);

/// Makes the meridians and parallels as lines, each once, on the vertices of `sphere`. Size:
/// wireSphereCounts.
Mesh wireSphere(double radius, int slices, int stacks);

extern const PrimitiveSpec kSphereRow;
extern const PrimitiveSpec kWireSphereRow;

// The upper half of a sphere, closed by a disk in the plane y = 0.

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

// Capsules about the origin: a cylinder around the y axis with a half sphere at each end.

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
