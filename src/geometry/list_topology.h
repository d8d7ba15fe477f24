#pragma once
// Splits the vertices of a glBegin list into separate primitives.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/list_mesh.h"

namespace glibra::geometry {

struct ListIndices {
    std::vector<std::uint32_t> indices;  ///< for meshTopology(topology)
    std::size_t dropped = 0;             ///< number of vertices of an incomplete last primitive
};

/// Returns the indices for a list of `count` vertices. Triangle strips keep the winding of the first triangle
/// (OpenGL 4.6 core, 10.1). A quad becomes (0,1,2) (0,2,3), in a strip (0,1,3) (0,3,2).
ListIndices listIndices(ListTopology topology, std::size_t count, int patchVertices);

}  // namespace glibra::geometry
