#pragma once
// The teapot.

#include <glm/vec3.hpp>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// From the original coordinates of the patches to ours: (x, y, z) -> (.5 x, .5 (z - 1.5), -.5 y).
glm::dvec3 teapotPlace(const glm::dvec3& original);

/// Triangles, counter-clockwise from outside: the 32 patches of `teapotPatches` in their order, each a grid
/// of cells x cells with its own vertices (the language has 16; at least 2), moved by `teapotPlace`: y up,
/// -.75 to .825, spout toward +x. s and t are 0..1 on every patch. Normals are the cross product of the
/// derivatives; triangles that are a line, at knob and bottom centre, are left out. Neighbouring patches have
/// equal positions along their common edge. Sizes: teapotCounts.
Mesh teapot(int cells = 16);

/// The patches as grids of 8 x 8 cells, all grid lines but those that are a point. Sizes: wireTeapotCounts.
Mesh wireTeapot();

}  // namespace glibra::geometry
