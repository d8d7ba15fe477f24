#pragma once
// The neighbours of a mesh's triangles, for geometry stages that read adjacency.

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

/// What stands at the far side of an edge.
enum class Neighbours {
    /// The first other triangle that traverses the edge in the opposite direction; without one, the first
    /// other triangle; without any, the triangle itself, turned over: its own far corner.
    oriented,
    /// As ObjAdj has it: the first other triangle; without any, the first vertex of the edge, which makes a
    /// neighbour of zero area.
    inOrder,
};

/// Returns the indices of a mesh of triangles as primitives with adjacency. Time and memory are linear.
///
/// trianglesAdjacency: the corners of each triangle are at 0, 2, 4; at 1, 3, 5 are the far corners of the
/// neighbours across 0-2, 2-4, 4-0. linesAdjacency: each edge that has a length once, in the order of first
/// use; its ends are at 1 and 2, in the order of the first triangle, whose far corner is at 0; the far corner
/// of the neighbour is at 3.
///
/// Two edges are the same if their ends have equal positions, so seams have neighbours (0 and -0 are equal).
/// An edge without length has no neighbour.
std::vector<std::uint32_t> adjacencyIndices(const Mesh& mesh, Topology topology,
                                            Neighbours neighbours = Neighbours::oriented);

}  // namespace glibra::geometry
