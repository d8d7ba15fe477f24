#pragma once
// Solids with flat faces.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

// Boxes about the origin.

constexpr Counts boxCounts() {
    return {24, 12};
}
constexpr Counts wireBoxCounts() {
    return {8, 12};
}

/// Makes a closed box with these side lengths >= 0, as triangles that are counter-clockwise seen from
/// outside. Each face has its own four vertices, with s and t from 0 to 1. Order of the faces, with the
/// directions of s and t: +x (-z, +y); -x (+z, +y); +y (+x, -z); -y (+x, +z); +z (+x, +y); -z (-x, +y).
/// Size: boxCounts.
Mesh box(double dx, double dy, double dz);

/// Makes the twelve edges as lines between eight corners, in the order x fastest, then y, then z. Normals
/// point along the diagonals of the box; s, t, p are 0 or 1 with x, y, z; tangents are T0(N). Size:
/// wireBoxCounts.
Mesh wireBox(double dx, double dy, double dz);

/// Makes a cube with that side length >= 0 to be seen from inside: triangles are counter-clockwise seen from
/// the centre, and normals point there. The texture coordinates (s, t, p) are the position divided by half of
/// the side, so that they, like the position itself, are the direction in which a cube map is read. Order of
/// the faces as above, with four vertices each. Tangents are T0(N). Size: boxCounts.
Mesh skyBox(double side);

extern const PrimitiveSpec kBoxRow;
extern const PrimitiveSpec kWireCubeRow;
extern const PrimitiveSpec kWireBoxRow;
extern const PrimitiveSpec kSkyBoxRow;

// Pyramids with a square base on the plane y = 0.

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

// The regular tetrahedron about the origin.

constexpr Counts tetrahedronCounts() {
    return {12, 4};
}

/// Makes a closed regular tetrahedron with its corners on the sphere of that radius >= 0, as triangles that
/// are counter-clockwise seen from outside. One corner is at (0, radius, 0); the other three lie in the plane
/// y = -radius/3, the first of them toward -z, so that one face looks toward +z. The edges have the length
/// radius sqrt(8/3). Each face has its own vertices and its own flat normal: three sides, then the bottom. On
/// each face the corners have (s, t) = (0, 0), (1, 0), (.5, 1), the last for the apex; on the bottom for the
/// corner toward -z. Tangents point along rising t. Size: tetrahedronCounts.
Mesh tetrahedron(double radius);

extern const PrimitiveSpec kTetrahedronRow;

// The ball with one upright picture per face.

constexpr Counts soccerballCounts(std::int64_t cuts = 8) {
    return detail::counted(90 * (cuts + 1) * (cuts + 2), 180 * cuts * cuts);
}

/// Makes a closed ball, as triangles that are counter-clockwise seen from outside: a truncated icosahedron
/// whose points are moved outward onto the sphere of that radius >= 0. Every face is a fan of flat triangles
/// (centre, corner, next corner), and each of these is cut into cuts x cuts before it is moved. cuts >= 1
/// (the language fixes 8).
///
/// The attribute `FaceIndex` has the number of the face. With the sphere coordinates s and latitude of
/// spheres.h and k = 0..4 the faces are: 0 the pentagon around +y; 1 + k pentagons at s = .25 + k/5, latitude
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
