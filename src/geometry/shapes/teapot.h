#pragma once
// The teapot.

#include <glm/vec3.hpp>

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

constexpr Counts teapotCounts(std::int64_t cells = 16) {
    return detail::counted(32 * (cells + 1) * (cells + 1), 64 * cells * cells - 8 * cells);
}
constexpr Counts wireTeapotCounts() {
    return {2592, 4544};
}

/// From the patches' original coordinates to model space: (x, y, z) -> (.5 x, .5 (z - 1.5), -.5 y).
glm::dvec3 teapotPlace(const glm::dvec3& original);

/// Makes the 32 patches of `teapotPatches` in their order, as triangles that are counter-clockwise seen from
/// outside. Each patch is a grid of cells x cells with its own vertices (cells >= 2),
/// moved by `teapotPlace`: y up, from -.75 to .825, the spout toward +x. s and t run from 0 to 1 on every
/// patch. Normals are the cross product of the derivatives. Triangles without area, at the knob and at the
/// centre of the bottom, are left out. Neighbouring patches have equal positions along their common edge.
/// Size: teapotCounts.
Mesh teapot(int cells = 16);

/// Makes the patches as grids of 8 x 8 cells: all grid lines but those that are a point. Size:
/// wireTeapotCounts.
Mesh wireTeapot();

extern const PrimitiveSpec kTeapotRow;
extern const PrimitiveSpec kWireTeapotRow;

}  // namespace glibra::geometry
