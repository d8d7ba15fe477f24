#include "geometry/obj/obj_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/obj/hash_index.h"
#include "geometry/obj/obj_vertices.h"

namespace glibra::geometry {
namespace {

/// The edges of triangles. Each is found by the welded positions of its ends and knows the first two
/// triangles that share it.
class EdgeTable {
  public:
    explicit EdgeTable(std::size_t triangles) : known_(3 * triangles) {
        edges_.reserve(triangles + triangles / 2);
    }

    /// Enters the sides in the order of the triangles. Side s of a triangle goes from its corner s to the
    /// next.
    void enter(std::uint32_t from, std::uint32_t to, std::uint32_t side) {
        const auto next = static_cast<std::uint32_t>(edges_.size());
        const std::uint64_t key = keyOf(from, to);
        const std::uint32_t edge =
            known_.findOrEnter(spread(key), next, [&](auto e) { return edges_[e].key == key; });
        if (edge == next)
            edges_.push_back({key, side, kNoIndex});
        else if (edges_[edge].second == kNoIndex && edges_[edge].first / 3 != side / 3)
            edges_[edge].second = side;
        ofSide_.push_back(edge);
    }

    /// Returns the first side of another triangle at the same edge, or kNoIndex.
    [[nodiscard]] std::uint32_t across(std::uint32_t side) const {
        const Edge& edge = edges_[ofSide_[side]];
        return edge.first / 3 == side / 3 ? edge.second : edge.first;
    }

    static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
        return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    }

  private:
    struct Edge {
        std::uint64_t key;
        std::uint32_t first, second;  ///< 3 * triangle + side
    };
    HashIndex known_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> ofSide_;
};

constexpr std::uint32_t nextSide(std::uint32_t side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

Mesh meshOf(const ObjModel& model, const ObjVertices& vertices, Topology topology, bool withTangents) {
    Mesh mesh;
    mesh.topology = topology;
    mesh.indices = fanIndices(model, vertices);
    mesh.attributes = objAttributes(model, vertices, mesh.indices, withTangents);
    return mesh;
}

}  // namespace

Mesh obj(const ObjModel& model, bool withTangents) {
    return meshOf(model, objVertices(model), Topology::triangles, withTangents);
}

Mesh objPatch(const ObjModel& model, bool withTangents) {
    Mesh mesh = meshOf(model, objVertices(model), Topology::patches, withTangents);
    mesh.patchVertices = 3;
    return mesh;
}

Mesh objAdj(const ObjModel& model, bool withTangents) {
    const ObjVertices vertices = objVertices(model);
    Mesh mesh = meshOf(model, vertices, Topology::trianglesAdjacency, withTangents);
    const std::vector<std::uint32_t> triangles = std::move(mesh.indices);
    const std::vector<std::uint32_t> welded = weldPositions(model.positions);
    const auto place = [&](std::uint32_t side) { return welded[vertices.corners[triangles[side]].position]; };

    const auto sides = static_cast<std::uint32_t>(triangles.size());
    EdgeTable edges(sides / 3);
    for (std::uint32_t side = 0; side < sides; ++side) edges.enter(place(side), place(nextSide(side)), side);

    mesh.indices.clear();
    mesh.indices.reserve(2 * triangles.size());
    for (std::uint32_t side = 0; side < sides; ++side) {
        const bool hasLength = place(side) != place(nextSide(side));
        const std::uint32_t other = hasLength ? edges.across(side) : kNoIndex;
        mesh.indices.push_back(triangles[side]);
        // The far corner of the other triangle is the one after the end of its side.
        mesh.indices.push_back(other == kNoIndex ? triangles[side] : triangles[nextSide(nextSide(other))]);
    }
    return mesh;
}

Mesh wireObj(const ObjModel& model, bool withTangents) {
    const ObjVertices vertices = objVertices(model);
    Mesh mesh = meshOf(model, vertices, Topology::lines, withTangents);
    mesh.indices.clear();
    std::vector<std::uint64_t> keys;
    HashIndex known(model.corners.size());
    for (std::size_t face = 0; face + 1 < model.faceStarts.size(); ++face) {
        const std::uint32_t begin = model.faceStarts[face], end = model.faceStarts[face + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t j = i + 1 == end ? begin : i + 1;
            const std::uint32_t from = model.corners[i].position, to = model.corners[j].position;
            if (from == to) continue;
            const std::uint64_t key = EdgeTable::keyOf(from, to);
            const auto next = static_cast<std::uint32_t>(keys.size());
            if (known.findOrEnter(spread(key), next, [&](std::uint32_t e) { return keys[e] == key; }) != next)
                continue;
            keys.push_back(key);
            mesh.indices.push_back(vertices.ofCorner[i]);
            mesh.indices.push_back(vertices.ofCorner[j]);
        }
    }
    return mesh;
}

}  // namespace glibra::geometry
