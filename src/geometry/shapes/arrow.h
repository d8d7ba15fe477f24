#pragma once
// The arrow whose range along x existing shaders rely on.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed, around the x axis (the language has 24 sides; at least
/// 3): shaft of radius .05 from x
/// = -1 to .6, head from radius .1 at x = .6 to the tip at x = 1. slices >= 2 along the arrow, about four
/// fifths of them on the shaft. Shaft and head: t = (x + 1) / 2, s around, 0 at +y, .25 at +z. Tail cap and
/// the head's back ring: s = .5 + z / 2R, t = .5 + y / 2R, R their outer radius. In this order: shaft, head,
/// tail cap, back ring. Sizes: xarrowCounts.
Mesh xarrow(int slices, int sides = 24);

/// How many of them are on the shaft.
int xarrowShaftSlices(int slices);

}  // namespace glibra::geometry
