#pragma once
// The neighbours of a mesh's triangles, for geometry stages that read adjacency.

#include <bit>
#include <cstdint>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

// An open-addressed table from keys kept elsewhere to the numbers 0, 1, 2 ... in order of first appearance.

/// The table holds only numbers; the caller keeps the keys and compares them.
class HashIndex {
  public:
    /// Makes a table for at most `most` different keys.
    explicit HashIndex(std::size_t most) : slots_(std::bit_ceil(most + most / 2 + 2), kNoIndex) {}

    /// Returns the number entered with that hash for which isKey(number) is true. If there is none, enters
    /// `next` and returns it.
    template <class IsKey>
    std::uint32_t findOrEnter(std::uint64_t hash, std::uint32_t next, IsKey isKey) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = static_cast<std::size_t>(hash) & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == kNoIndex) return slots_[slot] = next;
            if (isKey(slots_[slot])) return slots_[slot];
        }
    }

  private:
    std::vector<std::uint32_t> slots_;
};

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
