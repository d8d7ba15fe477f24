#pragma once
// Pyramids with a square base on the plane y = 0.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts pyramidCounts() {
    return {16, 6};
}

/// Makes a closed pyramid as triangles that are counter-clockwise seen from outside: the base is a square
/// with side `base`, centred in the plane y = 0 with its sides parallel to x and z; the apex is at y =
/// height. base, height >= 0. Each face has its own vertices and its own flat normal. Order of the faces,
/// with the direction of s: the sides toward +x (-z), -x (+z), +z (+x), -z (-x), then the base (s along +x, t
/// along +z). On a side s goes from 0 to 1 along the base edge, t from 0 there to 1 at the apex, which has s
/// = .5; tangents point from the middle of the edge to the apex. Size: pyramidCounts.
Mesh pyramid(double base, double height);

extern const PrimitiveSpec kPyramidRow;

}  // namespace glibra::geometry
