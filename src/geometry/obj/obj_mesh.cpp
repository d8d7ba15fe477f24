#include "geometry/obj/obj_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/adjacency.h"
#include "geometry/obj/hash_index.h"
#include "geometry/obj/obj_vertices.h"

namespace glibra::geometry {
namespace {

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
    Mesh mesh = obj(model, withTangents);
    mesh.indices = adjacencyIndices(mesh, Topology::trianglesAdjacency, Neighbours::inOrder);
    mesh.topology = Topology::trianglesAdjacency;
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
            const std::uint64_t key = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
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
