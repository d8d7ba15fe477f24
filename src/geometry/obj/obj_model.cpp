#include "geometry/obj/obj_model.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/hash.h"
#include "base/text.h"
#include "geometry/adjacency.h"
#include "geometry/frame.h"

namespace glibra::geometry {
namespace {

// The vertices that the corners of a model's polygons become.

struct ObjVertices {
    std::vector<std::uint32_t> ofCorner;  ///< the vertex of each corner of a face
    std::vector<std::uint32_t> ofLineCorner, ofPoint;
    std::vector<ObjCorner> corners;  ///< the triple (v, vt, vn) of each vertex
    /// The normals that corners without one get from their smoothing groups. They are numbered after those of
    /// the model.
    std::vector<glm::dvec3> groupNormals;
};

glm::dvec3 precise(const std::array<float, 3>& v) {
    return {v[0], v[1], v[2]};
}

void putVector(std::vector<float>& values, const glm::dvec3& v) {
    values.push_back(static_cast<float>(v.x));
    values.push_back(static_cast<float>(v.y));
    values.push_back(static_cast<float>(v.z));
}

bool hasOwnNormal(const ObjModel& model, const ObjCorner& corner) {
    return corner.normal != kNoIndex && model.normals[corner.normal] != std::array<float, 3>{0, 0, 0};
}

/// The area vector of a face, twice as long as its area.
glm::dvec3 areaOf(const ObjModel& model, std::size_t face) {
    const std::uint32_t begin = model.faceStarts[face], end = model.faceStarts[face + 1];
    const auto place = [&](std::uint32_t corner) {
        return precise(model.positions[model.corners[corner].position]);
    };
    const glm::dvec3 origin = place(begin);
    glm::dvec3 area(0);
    for (std::uint32_t i = begin + 1; i + 1 < end; ++i)
        area += glm::cross(place(i) - origin, place(i + 1) - origin);
    return area;
}

/// Returns for each position the sum of the area vectors of the faces around it, made a unit vector; zero if
/// there are no faces.
std::vector<glm::dvec3> smoothNormals(const ObjModel& model) {
    std::vector<glm::dvec3> normals(model.positions.size(), glm::dvec3(0));
    std::vector<glm::dvec3> someFace(model.positions.size(), glm::dvec3(0));
    for (std::size_t face = 0; face + 1 < model.faceStarts.size(); ++face) {
        const glm::dvec3 area = areaOf(model, face);
        for (std::uint32_t i = model.faceStarts[face]; i < model.faceStarts[face + 1]; ++i) {
            const std::uint32_t position = model.corners[i].position;
            normals[position] += area;
            if (someFace[position] == glm::dvec3(0)) someFace[position] = area;
        }
    }
    // Where faces cancel each other, as the two sides of a sheet do, the first face decides.
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] = unitOr(normals[i], unitOr(someFace[i], {0, 0, 1}));
    return normals;
}

/// The corners of all faces, of which those without a normal get one of `normals`: the mean of the faces of
/// their smoothing group around their position, or the normal of their own face if it has no group.
std::vector<ObjCorner> groupedCorners(const ObjModel& model, std::vector<glm::dvec3>& normals) {
    std::vector<ObjCorner> corners = model.corners;
    std::vector<glm::dvec3> someFace;
    std::vector<std::uint64_t> keys;  // of each normal, the group and the position; 0: of a face alone
    HashIndex known(corners.size());
    const auto add = [&](std::uint64_t key) {
        normals.emplace_back(0);
        someFace.emplace_back(0);
        keys.push_back(key);
    };
    for (std::size_t face = 0; face < model.faceCount(); ++face) {
        const glm::dvec3 area = areaOf(model, face);
        const std::uint64_t group = model.groups[face];
        if (group == kFlat) {
            add(0);
            normals.back() = area;
        }
        for (std::uint32_t i = model.faceStarts[face]; i < model.faceStarts[face + 1]; ++i) {
            auto normal = static_cast<std::uint32_t>(normals.size() - (group == kFlat ? 1 : 0));
            if (group != kFlat) {
                const std::uint64_t key = group << 32 | corners[i].position;
                const std::uint32_t next = normal;
                normal = known.findOrEnter(base::splitMixed(key), next,
                                           [&](std::uint32_t n) { return keys[n] == key; });
                if (normal == next) add(key);
                normals[normal] += area;
                if (someFace[normal] == glm::dvec3(0)) someFace[normal] = area;
            }
            if (!hasOwnNormal(model, corners[i]))
                corners[i].normal = static_cast<std::uint32_t>(model.normals.size()) + normal;
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
        normals[i] = unitOr(normals[i], unitOr(someFace[i], {0, 0, 1}));
    return corners;
}

std::vector<glm::dvec3> unitNormals(const ObjModel& model, const ObjVertices& vertices) {
    const auto isOfGroup = [&](const ObjCorner& corner) {
        return corner.normal != kNoIndex && corner.normal >= model.normals.size();
    };
    const auto hasNormal = [&](const ObjCorner& corner) {
        return isOfGroup(corner) || hasOwnNormal(model, corner);
    };
    std::vector<glm::dvec3> smooth;
    if (!std::ranges::all_of(vertices.corners, hasNormal)) smooth = smoothNormals(model);
    std::vector<glm::dvec3> normals;
    normals.reserve(vertices.corners.size());
    for (const ObjCorner& corner : vertices.corners) {
        if (isOfGroup(corner))
            normals.push_back(vertices.groupNormals[corner.normal - model.normals.size()]);
        else if (hasOwnNormal(model, corner))
            normals.push_back(unitOr(precise(model.normals[corner.normal]), {0, 0, 1}));
        else
            normals.push_back(smooth[corner.position]);
    }
    return normals;
}

glm::dvec3 texCoordOf(const ObjModel& model, const ObjCorner& corner) {
    return corner.texCoord == kNoIndex ? glm::dvec3(0) : precise(model.texCoords[corner.texCoord]);
}

/// Returns the direction of dP/dt on a triangle, with the triangle's area as its length; zero if the texture
/// coordinates are missing or lie on a line.
glm::dvec3 growingT(const ObjModel& model, const ObjCorner& a, const ObjCorner& b, const ObjCorner& c) {
    if (a.texCoord == kNoIndex || b.texCoord == kNoIndex || c.texCoord == kNoIndex) return glm::dvec3(0);
    const glm::dvec3 p = precise(model.positions[a.position]);
    const glm::dvec3 e1 = precise(model.positions[b.position]) - p,
                     e2 = precise(model.positions[c.position]) - p;
    const glm::dvec3 st = texCoordOf(model, a);
    const glm::dvec3 d1 = texCoordOf(model, b) - st, d2 = texCoordOf(model, c) - st;
    const double determinant = d1.x * d2.y - d2.x * d1.y;
    if (determinant == 0) return glm::dvec3(0);
    const glm::dvec3 direction = (d1.x * e2 - d2.x * e1) * (determinant > 0 ? 1. : -1.);
    return unitOr(direction, glm::dvec3(0)) * glm::length(glm::cross(e1, e2));
}

std::vector<float> tangentValues(const ObjModel& model, const ObjVertices& vertices,
                                 const std::vector<glm::dvec3>& normals,
                                 const std::vector<std::uint32_t>& triangles) {
    std::vector<glm::dvec3> sums(normals.size(), glm::dvec3(0));
    if (!model.texCoords.empty())
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const glm::dvec3 t =
                growingT(model, vertices.corners[a], vertices.corners[b], vertices.corners[c]);
            for (const std::uint32_t vertex : {a, b, c}) sums[vertex] += t;
        }
    std::vector<float> values;
    values.reserve(3 * normals.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const glm::dvec3 sum = unitOr(sums[i], glm::dvec3(0));
        const glm::dvec3 level = sum - glm::dot(sum, normals[i]) * normals[i];
        // A direction along the normal leaves only rounding errors.
        putVector(values, glm::length(level) < 1e-9 ? fallbackTangent(normals[i]) : glm::normalize(level));
    }
    return values;
}

/// Makes one vertex per different triple, in the order of first use. In a file with `s` lines, a corner
/// without a normal has one of groupNormals.
ObjVertices objVertices(const ObjModel& model) {
    ObjVertices vertices;
    std::vector<ObjCorner> grouped;
    if (!model.groups.empty() &&
        !std::ranges::all_of(model.corners, [&](const ObjCorner& c) { return hasOwnNormal(model, c); }))
        grouped = groupedCorners(model, vertices.groupNormals);
    const std::vector<ObjCorner>& ofFaces = grouped.empty() ? model.corners : grouped;
    // Most positions have one vertex. It is found without a hash, and near the last one in memory.
    std::vector<std::uint32_t> firstAt(model.positions.size(), kNoIndex);
    std::optional<HashIndex> others;
    const auto addAll = [&](const std::vector<ObjCorner>& corners, std::vector<std::uint32_t>& numbers) {
        numbers.reserve(corners.size());
        for (const ObjCorner& corner : corners) {
            const auto next = static_cast<std::uint32_t>(vertices.corners.size());
            const auto isCorner = [&](std::uint32_t v) { return vertices.corners[v] == corner; };
            std::uint32_t vertex = firstAt[corner.position];
            if (vertex == kNoIndex) {
                vertex = firstAt[corner.position] = next;
            } else if (!isCorner(vertex)) {
                if (!others)
                    others.emplace(model.corners.size() + model.lineCorners.size() + model.points.size());
                const std::uint64_t hash =
                    base::splitMixed((std::uint64_t{corner.position} << 32 | corner.texCoord) ^
                                     base::splitMixed(corner.normal));
                vertex = others->findOrEnter(hash, next, isCorner);
            }
            if (vertex == next) vertices.corners.push_back(corner);
            numbers.push_back(vertex);
        }
    };
    addAll(ofFaces, vertices.ofCorner);
    addAll(model.lineCorners, vertices.ofLineCorner);
    addAll(model.points, vertices.ofPoint);
    return vertices;
}

/// Returns three vertices for each triangle of the polygons: fans, and what the model says of its splitFaces.
std::vector<std::uint32_t> triangleIndices(const ObjModel& model, const ObjVertices& vertices) {
    std::vector<std::uint32_t> indices;
    indices.reserve(static_cast<std::size_t>(3 * model.triangleCount()));
    std::size_t split = 0, at = 0;  // the next of the split faces, and of their triangles
    for (std::size_t face = 0; face + 1 < model.faceStarts.size(); ++face) {
        const std::uint32_t begin = model.faceStarts[face], end = model.faceStarts[face + 1];
        if (split < model.splitFaces.size() && model.splitFaces[split] == face) {
            ++split;
            for (std::size_t n = 3 * std::size_t{end - begin - 2}; n > 0; --n)
                indices.push_back(vertices.ofCorner[begin + model.splitTriangles[at++]]);
            continue;
        }
        for (std::uint32_t i = begin + 1; i + 1 < end; ++i)
            for (const std::uint32_t corner : {begin, i, i + 1}) indices.push_back(vertices.ofCorner[corner]);
    }
    return indices;
}

/// Returns position, normal, texture coordinate and colour (if the model has any) and, if wanted, tangent of
/// each vertex, as described in obj_model.h.
std::vector<Attribute> objAttributes(const ObjModel& model, const ObjVertices& vertices,
                                     const std::vector<std::uint32_t>& triangles, bool withTangents) {
    const std::size_t count = vertices.corners.size();
    std::vector<Attribute> attributes;
    Attribute position{std::string(kPosition), 3, {}};
    position.values.reserve(3 * count);
    for (const ObjCorner& corner : vertices.corners) {
        const std::array<float, 3>& place = model.positions[corner.position];
        position.values.insert(position.values.end(), place.begin(), place.end());
    }
    attributes.push_back(std::move(position));

    const std::vector<glm::dvec3> normals = unitNormals(model, vertices);
    Attribute normal{std::string(kNormal), 3, {}};
    normal.values.reserve(3 * count);
    for (const glm::dvec3& each : normals) putVector(normal.values, each);
    attributes.push_back(std::move(normal));

    if (withTangents)
        attributes.push_back({std::string(kTangent), 3, tangentValues(model, vertices, normals, triangles)});

    if (!model.texCoords.empty()) {
        const bool hasP = std::ranges::any_of(model.texCoords,
                                              [](const std::array<float, 3>& each) { return each[2] != 0; });
        Attribute texCoord{std::string(kTexCoord), hasP ? 3 : 2, {}};
        texCoord.values.reserve(count * static_cast<std::size_t>(texCoord.components));
        for (const ObjCorner& corner : vertices.corners)
            for (int c = 0; c < texCoord.components; ++c)
                texCoord.values.push_back(
                    corner.texCoord == kNoIndex
                        ? 0
                        : model.texCoords[corner.texCoord][static_cast<std::size_t>(c)]);
        attributes.push_back(std::move(texCoord));
    }

    if (!model.colors.empty()) {
        Attribute color{std::string(kColor), 4, {}};
        color.values.reserve(4 * count);
        for (const ObjCorner& corner : vertices.corners) {
            const Triple& each = model.colors[corner.position];
            color.values.insert(color.values.end(), {each[0], each[1], each[2], 1.F});
        }
        attributes.push_back(std::move(color));
    }
    return attributes;
}

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
        if (known.findOrEnter(base::splitMixed(key), next, [&](std::uint32_t e) { return keys[e] == key; }) !=
            next)
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

namespace {
constexpr std::size_t kMostOfAKind = 100;
}

std::string shown(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string out(text.substr(0, kLongest));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    if (text.size() > kLongest) out += "...";
    return out;
}

std::string_view fileName(std::string_view path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

void FileRemarks::warn(std::string_view id, std::string_view text, int line, int column) {
    auto count = warningCounts_.find(id);
    if (count == warningCounts_.end()) count = warningCounts_.emplace(id, 0).first;
    if (count->second++ < kMostOfAKind)
        warnings_.push_back(diagnose(std::string(id), std::string(text), place(line, column)));
}

void FileRemarks::ignored(std::string_view word, int line, int column) {
    auto known = ignored_.find(word);
    if (known == ignored_.end()) {
        if (ignored_.size() == kMostOfAKind) {
            ++otherIgnored_;
            return;
        }
        known = ignored_.emplace(word, Ignored{0, line, column}).first;
    }
    ++known->second.count;
}

Diagnostics FileRemarks::finish() && {
    for (const auto& [word, where] : ignored_)
        warnings_.push_back(diagnose("file-W04",
                                     fmt::format("{} '{}' {} ignored", base::groupedText(where.count),
                                                 shown(word), where.count == 1 ? "line" : "lines"),
                                     place(where.line, where.column)));
    std::ranges::stable_sort(warnings_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    if (otherIgnored_ > 0)
        warnings_.push_back(diagnose(
            "file-W04", fmt::format("{} lines with other words ignored", base::groupedText(otherIgnored_)),
            place(1, 1)));
    for (const auto& [id, count] : warningCounts_)
        if (count > kMostOfAKind)
            warnings_.push_back(
                diagnose(id, fmt::format("{} more of this kind", base::groupedText(count - kMostOfAKind)),
                         place(1, 1)));
    return std::move(warnings_);
}

}  // namespace glibra::geometry
