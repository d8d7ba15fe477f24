#pragma once
// Spheres about the origin, with the poles on the y axis.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
