#pragma once
// Boxes about the origin.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
