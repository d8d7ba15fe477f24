#pragma once
// The mesh, which all geometry becomes: named attributes per vertex, and indices that form primitives.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::geometry {

/// How consecutive indices form primitives. Quads, strips, fans and polygons have been split into these.
enum class Topology { points, lines, linesAdjacency, triangles, trianglesAdjacency, patches };
/// "triangles with adjacency"
constexpr std::string_view wordsOf(Topology topology) {
    switch (topology) {
        case Topology::points:
            return "points";
        case Topology::lines:
            return "lines";
        case Topology::linesAdjacency:
            return "lines with adjacency";
        case Topology::triangles:
            return "triangles";
        case Topology::trianglesAdjacency:
            return "triangles with adjacency";
        case Topology::patches:
            break;
    }
    return "patches";
}

/// Names of the attributes. A mesh holds only those that vary over it. A missing colour reads as the current
/// colour, a missing FaceIndex as 0, every other missing attribute as (0, 0, 0, 1).
inline constexpr std::string_view kPosition = "position";  ///< 3 or 4 numbers, model space; 3: w = 1
inline constexpr std::string_view kNormal = "normal";      ///< 3 numbers, unit length, model space
inline constexpr std::string_view kTexCoord =
    "texCoord";  ///< 2, 3 or 4 numbers s, t, p, q; missing ones 0, 0, 1
inline constexpr std::string_view kTangent = "tangent";      ///< 3 numbers, unit length, model space
inline constexpr std::string_view kColor = "color";          ///< 4 numbers, red, green, blue, alpha
inline constexpr std::string_view kFaceIndex = "faceIndex";  ///< 1 number, a small integer

/// One attribute of all vertices: `components` floats per vertex, vertex after vertex.
struct Attribute {
    std::string name;
    int components = 0;
    std::vector<float> values;
};

struct Mesh {
    Topology topology = Topology::triangles;
    int patchVertices = 0;  ///< vertices per patch, for Topology::patches only
    std::vector<Attribute> attributes;
    std::vector<std::uint32_t> indices;
    /// The last of the indices are points, whatever the topology is; this many.
    std::size_t pointCount = 0;

    /// The number of vertices stored.
    [[nodiscard]] std::size_t vertexCount() const {
        const Attribute* position = attribute(kPosition);
        return position ? position->values.size() / static_cast<std::size_t>(position->components) : 0;
    }
    /// The attribute with that name, or null.
    [[nodiscard]] const Attribute* attribute(std::string_view name) const {
        for (const Attribute& each : attributes)
            if (each.name == name) return &each;
        return nullptr;
    }
};

/// The number of indices that one primitive takes.
constexpr int verticesPerPrimitive(Topology topology, int patchVertices = 0) {
    switch (topology) {
        case Topology::points:
            return 1;
        case Topology::lines:
            return 2;
        case Topology::linesAdjacency:
            return 4;
        case Topology::triangles:
            return 3;
        case Topology::trianglesAdjacency:
            return 6;
        case Topology::patches:
            break;
    }
    return patchVertices;
}

}  // namespace glibra::geometry
