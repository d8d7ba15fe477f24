#pragma once
// Cones that stand on the plane y = 0, around the y axis.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed: base at y = 0, apex at y = height. radius, height >= 0,
/// slices >= 3, stacks >= 1. Side: s around as on the sphere (0 on -x, .25 on +z), t = y / height along the
/// slant, normals across the slant; the apex holds one vertex a slice, with s and normal of the slice's
/// middle. Base: s = .5 + x / 2R, t = .5 + z / 2R. In this order: side, base. Sizes: coneCounts.
Mesh cone(double radius, double height, int slices, int stacks);

/// The side's grid as lines. Sizes: wireConeCounts.
Mesh wireCone(double radius, double height, int slices, int stacks);

}  // namespace glibra::geometry
