#include "geometry/adjacency.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

#include "base/hash.h"

namespace glibra::geometry {
namespace {

/// Returns for each vertex the number of the first one with an equal position.
std::vector<std::uint32_t> weldVertices(const Attribute& position) {
    const auto size = static_cast<std::size_t>(position.components);
    const std::size_t count = position.values.size() / size;
    const auto place = [&](std::size_t vertex) {
        return std::span(position.values).subspan(size * vertex, size);
    };
    std::vector<std::uint32_t> first;
    first.reserve(count);
    HashIndex known(count);
    for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
        const auto own = place(vertex);
        std::uint64_t hash = 0;
        for (const float coordinate : own)
            hash = base::splitMixed(hash ^ std::bit_cast<std::uint32_t>(coordinate + 0.F));  // -0 becomes 0
        first.push_back(known.findOrEnter(
            hash, vertex, [&](std::uint32_t other) { return std::ranges::equal(place(other), own); }));
    }
    return first;
}

// A side is a corner of a triangle and stands for the edge from there to the next corner: 3 * triangle +
// corner.

constexpr std::uint32_t nextSide(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

/// The edges of triangles, found by the welded positions of their ends.
class EdgeTable {
  public:
    explicit EdgeTable(std::size_t sides) : known_(sides) {
        edges_.reserve(sides / 2);
        ofSide_.reserve(sides);
    }

    /// Enters the sides in their order.
    void enter(std::uint32_t from, std::uint32_t to) {
        const auto side = static_cast<std::uint32_t>(ofSide_.size());
        const auto next = static_cast<std::uint32_t>(edges_.size());
        const std::uint64_t key = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
        const std::uint32_t edge =
            known_.findOrEnter(base::splitMixed(key), next, [&](auto e) { return edges_[e].key == key; });
        if (edge == next) edges_.push_back({key, {}, {}});
        const bool isForward = from < to;
        Sides& along = isForward ? edges_[edge].forward : edges_[edge].backward;
        if (along.first == kNoIndex)
            along.first = side;
        else if (along.second == kNoIndex && along.first / 3 != side / 3)
            along.second = side;
        ofSide_.push_back(edge);
        isForward_.push_back(isForward);
    }

    /// Returns the side of the neighbour at the same edge, or kNoIndex.
    [[nodiscard]] std::uint32_t across(std::uint32_t side, Neighbours neighbours) const {
        const Edge& edge = edges_[ofSide_[side]];
        const auto other = [&](const Sides& along) {
            return along.first != kNoIndex && along.first / 3 == side / 3 ? along.second : along.first;
        };
        const std::uint32_t opposite = other(isForward_[side] ? edge.backward : edge.forward);
        const std::uint32_t same = other(isForward_[side] ? edge.forward : edge.backward);
        if (neighbours == Neighbours::inOrder) return std::min(opposite, same);
        return opposite != kNoIndex ? opposite : same;
    }

    /// True for the side that was entered first of its edge.
    [[nodiscard]] bool isFirst(std::uint32_t side) const {
        const Edge& edge = edges_[ofSide_[side]];
        return side == std::min(edge.forward.first, edge.backward.first);
    }

  private:
    /// The first sides of two different triangles along an edge, in one direction.
    struct Sides {
        std::uint32_t first = kNoIndex, second = kNoIndex;
    };
    struct Edge {
        std::uint64_t key;
        Sides forward, backward;
    };
    HashIndex known_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> ofSide_;
    std::vector<bool> isForward_;
};

}  // namespace

std::vector<std::uint32_t> adjacencyIndices(const Mesh& mesh, Topology topology, Neighbours neighbours) {
    assert(mesh.topology == Topology::triangles);
    assert(topology == Topology::trianglesAdjacency || topology == Topology::linesAdjacency);
    const std::vector<std::uint32_t>& corners = mesh.indices;
    const Attribute* position = mesh.attribute(kPosition);
    if (position == nullptr || corners.empty()) return {};
    const std::vector<std::uint32_t> welded = weldVertices(*position);
    const auto place = [&](std::uint32_t side) { return welded[corners[side]]; };
    const auto hasLength = [&](std::uint32_t side) { return place(side) != place(nextSide(side)); };

    const auto sides = static_cast<std::uint32_t>(corners.size());
    EdgeTable edges(sides);
    for (std::uint32_t side = 0; side < sides; ++side) edges.enter(place(side), place(nextSide(side)));

    // The far corner of a triangle is the one after the end of its side.
    const auto farCorner = [&](std::uint32_t side) { return corners[nextSide(nextSide(side))]; };
    const auto neighbour = [&](std::uint32_t side) {
        const std::uint32_t other = hasLength(side) ? edges.across(side, neighbours) : kNoIndex;
        if (other != kNoIndex) return farCorner(other);
        return neighbours == Neighbours::inOrder ? corners[side] : farCorner(side);
    };
    std::vector<std::uint32_t> indices;
    indices.reserve(2 * corners.size());
    for (std::uint32_t side = 0; side < sides; ++side) {
        if (topology == Topology::trianglesAdjacency)
            indices.insert(indices.end(), {corners[side], neighbour(side)});
        else if (hasLength(side) && edges.isFirst(side))
            indices.insert(indices.end(),
                           {farCorner(side), corners[side], corners[nextSide(side)], neighbour(side)});
    }
    return indices;
}

}  // namespace glibra::geometry
