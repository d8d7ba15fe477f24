#include "geometry/obj/obj_mesh.h"

#include <algorithm>
#include <utility>

#include "geometry/adjacency.h"
#include "geometry/hash_index.h"
#include "geometry/obj/obj_vertices.h"

namespace glibra::geometry {
namespace {

Mesh meshOf(const ObjModel& model, const ObjVertices& vertices, Topology topology, bool withTangents) {
    Mesh mesh;
    mesh.topology = topology;
    mesh.indices = triangleIndices(model, vertices);
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
    HashIndex known(model.corners.size() + model.lineCorners.size());
    const auto addEdge = [&](const ObjCorner& a, std::uint32_t vertexA, const ObjCorner& b,
                             std::uint32_t vertexB) {
        const std::uint32_t from = a.position, to = b.position;
        if (from == to) return;
        const std::uint64_t key = std::uint64_t{std::min(from, to)} << 32 | std::max(from, to);
        const auto next = static_cast<std::uint32_t>(keys.size());
        if (known.findOrEnter(spread(key), next, [&](std::uint32_t e) { return keys[e] == key; }) != next)
            return;
        keys.push_back(key);
        mesh.indices.push_back(vertexA);
        mesh.indices.push_back(vertexB);
    };
    for (std::size_t face = 0; face + 1 < model.faceStarts.size(); ++face) {
        const std::uint32_t begin = model.faceStarts[face], end = model.faceStarts[face + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t j = i + 1 == end ? begin : i + 1;
            addEdge(model.corners[i], vertices.ofCorner[i], model.corners[j], vertices.ofCorner[j]);
        }
    }
    for (std::size_t line = 0; line + 1 < model.lineStarts.size(); ++line)
        for (std::uint32_t i = model.lineStarts[line]; i + 1 < model.lineStarts[line + 1]; ++i)
            addEdge(model.lineCorners[i], vertices.ofLineCorner[i], model.lineCorners[i + 1],
                    vertices.ofLineCorner[i + 1]);
    mesh.indices.insert(mesh.indices.end(), vertices.ofPoint.begin(), vertices.ofPoint.end());
    mesh.pointCount = vertices.ofPoint.size();
    return mesh;
}

}  // namespace glibra::geometry
