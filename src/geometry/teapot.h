#pragma once
// The teapot.

#include "geometry/mesh.h"

namespace glibra::geometry {

/// Triangles, counter-clockwise from outside: the 32 patches of `teapotPatches` in their order, each a grid
/// of 16 x 16 cells with its own vertices, moved by (x, y, z) -> (.5 x, .5 (z - 1.5), -.5 y): y up, -.75 to
/// .825, spout toward +x. s and t are 0..1 on every patch. Normals are the cross product of the derivatives;
/// triangles that are a line, at knob and bottom centre, are left out. Neighbouring patches have equal
/// positions along their common edge. Sizes: teapotCounts.
Mesh teapot();

/// The patches as grids of 8 x 8 cells, all grid lines but those that are a point. Sizes: wireTeapotCounts.
Mesh wireTeapot();

}  // namespace glibra::geometry
