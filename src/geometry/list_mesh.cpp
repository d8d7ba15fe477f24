#include "geometry/list_mesh.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/text.h"
#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

using Indices = std::vector<std::uint32_t>;

void putIndices(Indices& indices, std::initializer_list<std::uint32_t> more) {
    indices.insert(indices.end(), more);
}

/// Returns triangle i of a strip with adjacency that has `count` triangles (OpenGL 4.6 core, table 10.1).
/// Even vertices form the strip; odd ones are the neighbours across its outer edges. Across an inner edge the
/// neighbour is the far corner of the next triangle.
void putStripAdjacency(Indices& indices, std::uint32_t i, std::uint32_t count) {
    const std::uint32_t at = 2 * i;
    const std::uint32_t before = i == 0 ? 1 : at - 2;
    const std::uint32_t after = i + 1 == count ? at + 5 : at + 6;
    if (i % 2 == 0)
        putIndices(indices, {at, before, at + 2, after, at + 4, at + 3});
    else
        putIndices(indices, {at + 2, before, at, at + 3, at + 4, after});
}

}  // namespace

std::optional<ListTopology> listTopology(std::string_view word) {
    const std::string plain = base::lower(word.substr(0, 64));
    std::string_view bare = plain;
    if (bare.starts_with("gl_")) bare.remove_prefix(3);
    const auto* const found = std::ranges::find(kListTopologyWords, bare);
    if (found == kListTopologyWords.end()) return std::nullopt;
    return static_cast<ListTopology>(found - kListTopologyWords.begin());
}

Topology meshTopology(ListTopology topology) {
    switch (topology) {
        case ListTopology::points:
            return Topology::points;
        case ListTopology::lines:
        case ListTopology::lineStrip:
        case ListTopology::lineLoop:
            return Topology::lines;
        case ListTopology::linesAdjacency:
        case ListTopology::lineStripAdjacency:
            return Topology::linesAdjacency;
        case ListTopology::trianglesAdjacency:
        case ListTopology::triangleStripAdjacency:
            return Topology::trianglesAdjacency;
        case ListTopology::patches:
            return Topology::patches;
        default:
            return Topology::triangles;
    }
}

ListIndices listIndices(ListTopology topology, std::size_t count, int patchVertices) {
    Indices out;
    const auto n = static_cast<std::uint32_t>(count);
    // Primitives that share vertices: the first takes `least` vertices, each further one `step` more.
    const auto shared = [&](std::uint32_t least, std::uint32_t step, auto putPrimitive) {
        if (n < least) return n;
        const std::uint32_t primitives = (n - least) / step + 1;
        for (std::uint32_t i = 0; i < primitives; ++i) putPrimitive(i, primitives);
        return (n - least) % step;
    };
    std::uint32_t dropped = 0;
    switch (topology) {
        case ListTopology::points:
        case ListTopology::lines:
        case ListTopology::triangles:
        case ListTopology::linesAdjacency:
        case ListTopology::trianglesAdjacency:
        case ListTopology::patches: {
            const int size = verticesPerPrimitive(meshTopology(topology), patchVertices);
            assert(size >= 1);
            dropped = n % static_cast<std::uint32_t>(size);
            out.resize(n - dropped);
            std::iota(out.begin(), out.end(), 0U);
            break;
        }
        case ListTopology::lineStrip:
        case ListTopology::lineLoop:
            dropped = shared(2, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {i, i + 1}); });
            if (topology == ListTopology::lineLoop && n >= 2) putIndices(out, {n - 1, 0});
            break;
        case ListTopology::triangleStrip:
            dropped = shared(3, 1, [&](std::uint32_t i, std::uint32_t) {
                putIndices(out, {i + i % 2, i + 1 - i % 2, i + 2});
            });
            break;
        case ListTopology::triangleFan:
        case ListTopology::polygon:
            dropped =
                shared(3, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {0, i + 1, i + 2}); });
            break;
        case ListTopology::quads:
            for (std::uint32_t a = 0; a + 4 <= n; a += 4) putIndices(out, {a, a + 1, a + 2, a, a + 2, a + 3});
            dropped = n % 4;
            break;
        case ListTopology::quadStrip:
            dropped = shared(4, 2, [&](std::uint32_t i, std::uint32_t) {
                const std::uint32_t a = 2 * i;
                putIndices(out, {a, a + 1, a + 3, a, a + 3, a + 2});
            });
            break;
        case ListTopology::lineStripAdjacency:
            dropped = shared(
                4, 1, [&](std::uint32_t i, std::uint32_t) { putIndices(out, {i, i + 1, i + 2, i + 3}); });
            break;
        case ListTopology::triangleStripAdjacency:
            dropped =
                shared(6, 2, [&](std::uint32_t i, std::uint32_t all) { putStripAdjacency(out, i, all); });
            break;
    }
    return {std::move(out), dropped};
}

namespace {

template <std::size_t N>
using Components = std::array<double, N>;

glm::dvec3 euclidean(const Components<4>& point) {
    const glm::dvec3 xyz{point[0], point[1], point[2]};
    return point[3] == 0 ? xyz : xyz / point[3];
}

constexpr glm::dvec3 kTowardViewer{0, 0, 1};

/// Adds up the area vectors of the triangles around each vertex. Separate primitives share no vertices, so a
/// triangle or quad gets the normal of its own face: the two halves of a quad are added at all four corners.
std::vector<glm::dvec3> computedNormals(ListTopology topology, std::span<const ListVertex> vertices,
                                        std::span<const std::uint32_t> indices) {
    std::vector<glm::dvec3> normals(vertices.size(), kTowardViewer);
    if (meshTopology(topology) != Topology::triangles) return normals;
    std::ranges::fill(normals, glm::dvec3(0));
    const auto place = [&](std::uint32_t index) { return euclidean(vertices[index].position); };
    for (std::size_t i = 0; i + 3 <= indices.size(); i += 3) {
        const glm::dvec3 a = place(indices[i]), b = place(indices[i + 1]), c = place(indices[i + 2]);
        const glm::dvec3 area = glm::cross(b - a, c - a);
        if (topology == ListTopology::quads) {
            const std::size_t quad = indices[i] - indices[i] % 4;
            for (std::size_t corner = quad; corner < quad + 4; ++corner) normals[corner] += area;
        } else {
            for (std::size_t corner = i; corner < i + 3; ++corner) normals[indices[corner]] += area;
        }
    }
    for (glm::dvec3& normal : normals) normal = unitOr(normal, kTowardViewer);
    return normals;
}

/// Makes an attribute from the first `components` numbers that `numbersOf` returns for each of `count`
/// vertices.
template <class NumbersOf>
Attribute attributeOf(std::string_view name, int components, std::size_t count, NumbersOf numbersOf) {
    Attribute attribute{std::string(name), components, {}};
    attribute.values.reserve(count * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < count; ++i) {
        const auto numbers = numbersOf(i);
        for (int c = 0; c < components; ++c)
            attribute.values.push_back(static_cast<float>(numbers[static_cast<std::size_t>(c)]));
    }
    return attribute;
}

Components<3> numbersOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// Returns how many components of the texture coordinates are needed: those that differ from (0, 0, 0, 1),
/// which a missing one reads. The result is 0 or at least 2.
int texCoordComponents(std::span<const ListVertex> vertices) {
    int components = 0;
    for (const ListVertex& vertex : vertices) {
        if (vertex.texCoord[3] != 1) return 4;
        if (vertex.texCoord[2] != 0)
            components = 3;
        else if (vertex.texCoord[0] != 0 || vertex.texCoord[1] != 0)
            components = std::max(components, 2);
    }
    return components;
}

bool allWeightsOne(std::span<const ListVertex> vertices) {
    return std::ranges::all_of(vertices, [](const ListVertex& v) { return v.position[3] == 1; });
}

}  // namespace

ListMesh meshFromList(ListTopology topology, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices) {
    ListMesh list;
    list.mesh.topology = meshTopology(topology);
    if (topology == ListTopology::patches) list.mesh.patchVertices = patchVertices;
    ListIndices numbered = listIndices(topology, vertices.size(), patchVertices);
    list.mesh.indices = std::move(numbered.indices);
    list.dropped = numbered.dropped;
    if (vertices.empty()) return list;

    std::vector<glm::dvec3> normals;
    if (hasNormals)
        for (const ListVertex& vertex : vertices)
            normals.emplace_back(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
    else
        normals = computedNormals(topology, vertices, list.mesh.indices);

    const std::size_t count = vertices.size();
    std::vector<Attribute>& attributes = list.mesh.attributes;
    attributes.push_back(attributeOf(kPosition, allWeightsOne(vertices) ? 3 : 4, count,
                                     [&](std::size_t i) { return vertices[i].position; }));
    attributes.push_back(
        attributeOf(kNormal, 3, count, [&](std::size_t i) { return numbersOf(normals[i]); }));
    attributes.push_back(attributeOf(kTangent, 3, count,
                                     [&](std::size_t i) { return numbersOf(fallbackTangent(normals[i])); }));
    if (const int components = texCoordComponents(vertices); components > 0)
        attributes.push_back(
            attributeOf(kTexCoord, components, count, [&](std::size_t i) { return vertices[i].texCoord; }));
    if (std::ranges::all_of(vertices, [&](const ListVertex& v) { return v.color == vertices.front().color; }))
        list.color = vertices.front().color;
    else
        attributes.push_back(attributeOf(kColor, 4, count, [&](std::size_t i) { return vertices[i].color; }));
    return list;
}

ListMesh meshFromList(std::string_view topologyWord, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices) {
    const std::optional<ListTopology> topology = listTopology(topologyWord);
    assert(topology);
    return meshFromList(topology.value_or(ListTopology::points), vertices, hasNormals, patchVertices);
}

Mesh trianglesList(std::span<const std::array<double, 4>> points) {
    assert(points.size() % 3 == 0);
    constexpr std::array<Components<4>, 3> kCorners{{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}}};
    std::vector<ListVertex> vertices;
    vertices.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        vertices.push_back({.position = points[i], .texCoord = kCorners[i % 3]});
    return meshFromList(ListTopology::triangles, vertices, false, 0).mesh;
}

Mesh linesAdjacencyList(std::span<const std::array<double, 4>> points) {
    assert(points.size() % 4 == 0);
    std::vector<ListVertex> vertices;
    vertices.reserve(points.size());
    for (const std::array<double, 4>& point : points) vertices.push_back({.position = point});
    return meshFromList(ListTopology::linesAdjacency, vertices, false, 0).mesh;
}

}  // namespace glibra::geometry
