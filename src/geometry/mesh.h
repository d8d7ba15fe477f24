#pragma once
// The mesh, which all geometry becomes: named attributes per vertex, and indices that form primitives.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::geometry {

/// Stands for "no index"; larger than every index.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

/// How consecutive indices form primitives. Quads, strips, fans and polygons have been split into these.
enum class Topology { points, lines, linesAdjacency, triangles, trianglesAdjacency, patches };
/// "triangles with adjacency"
constexpr std::string_view wordsOf(Topology topology) {
    constexpr std::array<std::string_view, 6> kWords{
        "points", "lines", "lines with adjacency", "triangles", "triangles with adjacency", "patches"};
    return kWords.at(static_cast<std::size_t>(topology));
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
    constexpr std::array<int, 5> kCounts{1, 2, 4, 3, 6};
    return topology == Topology::patches ? patchVertices : kCounts.at(static_cast<std::size_t>(topology));
}

// The size of a mesh, known in closed form and in 64 bits before the mesh is made.

/// The most vertices that one command may have, and the most cells along one direction of a shape (language,
/// 11).
inline constexpr std::uint64_t kMostVertices = 8'388'608;
inline constexpr int kMostSubdivisions = 65'536;

/// The number of vertices stored, and of triangles, segments or points drawn. Each shape's header has the
/// function that gives them. Arguments of up to 2^20 cannot overflow.
struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t primitives = 0;

    friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

namespace detail {
constexpr Counts counted(std::int64_t vertices, std::int64_t primitives) {
    return {static_cast<std::uint64_t>(vertices), static_cast<std::uint64_t>(primitives)};
}
}  // namespace detail

}  // namespace glibra::geometry
