#pragma once
// The regular tetrahedron about the origin.

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
