#pragma once
// Cones that stand on the plane y = 0, around the y axis.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
