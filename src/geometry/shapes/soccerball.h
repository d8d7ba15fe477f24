#pragma once
// The ball with one upright picture per face.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts soccerballCounts(std::int64_t cuts = 8) {
    return detail::counted(90 * (cuts + 1) * (cuts + 2), 180 * cuts * cuts);
}

/// Makes a closed ball, as triangles that are counter-clockwise seen from outside: a truncated icosahedron
/// whose points are moved outward onto the sphere of that radius >= 0. Every face is a fan of flat triangles
/// (centre, corner, next corner), and each of these is cut into cuts x cuts before it is moved. cuts >= 1
/// (the language fixes 8).
///
/// The attribute `FaceIndex` has the number of the face. With the sphere coordinates s and latitude of
/// sphere.h and k = 0..4 the faces are: 0 the pentagon around +y; 1 + k pentagons at s = .25 + k/5, latitude
/// atan(1/2); 6 + k pentagons at s = .35 + k/5, latitude -atan(1/2); 11 the pentagon around -y; hexagons 12 +
/// k touch 0, 1 + k, 1 + (k+1) mod 5; 17 + k touch 1 + k, 1 + (k+1) mod 5, 6 + k; 22 + k have their centre at
/// s = .25 + k/5 and touch 1 + k and its two lower neighbours; 27 + k lie below those and touch 11.
///
/// s and t are flat coordinates of the face, with t toward the north pole and the circle through the corners
/// inscribed in 0..1; faces 0 and 11 use T0 of their centre for t. p is 0 at the face's centre and 1 on the
/// seam. Tangents point to the north pole. Size: soccerballCounts.
Mesh soccerball(double radius, int cuts = 8);

extern const PrimitiveSpec kSoccerballRow;

}  // namespace glibra::geometry
