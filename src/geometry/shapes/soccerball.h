#pragma once
// The ball with one upright picture a face.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside, closed: a truncated icosahedron pushed onto the sphere of that
/// radius >= 0. Every face is a fan of flat triangles (centre, corner, next corner), each cut into cuts x
/// cuts before it is pushed (the language has 8; at least 1).
///
/// Faces, `FaceIndex` constant on each; sphere coordinates (s, latitude) as in sphere.h, k = 0..4:
/// 0 the pentagon around +y; 1 + k pentagons at s = .25 + k/5, latitude atan(1/2); 6 + k pentagons at s = .35
/// + k/5, latitude -atan(1/2); 11 the pentagon around -y; hexagons 12 + k touch 0, 1 + k, 1 + (k+1) mod 5; 17
/// + k the same two and 6 + k; 22 + k centre s = .25 + k/5, touch 1 + k and its two lower neighbours; 27 + k
/// below those, touch 11.
///
/// s, t: flat coordinates of the face, t toward the north pole, the circle through the corners is inscribed
/// in 0..1; faces 0 and 11 take T0 of their centre for t. p = 0 at the face's centre, 1 on the seam. Tangents
/// point to the north pole. Sizes: soccerballCounts.
Mesh soccerball(double radius, int cuts = 8);

}  // namespace glibra::geometry
