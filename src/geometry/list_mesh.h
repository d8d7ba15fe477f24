#pragma once
// Meshes whose vertices stand in the scene's text: glBegin lists, Triangles, LinesAdjacency.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

// The topologies of glBegin, and how they split a list of vertices into separate primitives.

/// The topologies of glBegin.
enum class ListTopology {
    points,
    lines,
    lineStrip,
    lineLoop,
    triangles,
    triangleStrip,
    triangleFan,
    polygon,
    quads,
    quadStrip,
    linesAdjacency,
    lineStripAdjacency,
    trianglesAdjacency,
    triangleStripAdjacency,
    patches
};

/// Their words in scenes, in this order.
inline constexpr auto kListTopologyWords = std::to_array<std::string_view>(
    {"points", "lines", "line_strip", "line_loop", "triangles", "triangle_strip", "triangle_fan", "polygon",
     "quads", "quad_strip", "lines_adjacency", "line_strip_adjacency", "triangles_adjacency",
     "triangle_strip_adjacency", "patches"});
static_assert(kListTopologyWords.size() == static_cast<std::size_t>(ListTopology::patches) + 1);

/// Returns the topology with that name, for example `triangle_strip`, with or without the prefix `gl_`, in
/// any case; nothing for other words.
std::optional<ListTopology> listTopology(std::string_view word);

/// Returns the topology of the resulting mesh: Topology::triangles for strips, fans, polygons and quads, and
/// so on.
Topology meshTopology(ListTopology topology);

struct ListIndices {
    std::vector<std::uint32_t> indices;  ///< for meshTopology(topology)
    std::size_t dropped = 0;             ///< number of vertices of an incomplete last primitive
};

/// Returns the indices for a list of `count` vertices. Triangle strips keep the winding of the first triangle
/// (OpenGL 4.6 core, 10.1). A quad becomes (0,1,2) (0,2,3), in a strip (0,1,3) (0,3,2).
ListIndices listIndices(ListTopology topology, std::size_t count, int patchVertices);

/// One vertex of a list, with the state at its glVertex.
struct ListVertex {
    std::array<double, 4> position{0, 0, 0, 1};
    std::array<double, 3> normal{0, 0, 1};
    std::array<double, 4> color{1, 1, 1, 1};  ///< red, green, blue, alpha
    std::array<double, 4> texCoord{0, 0, 0, 1};
};

struct ListMesh {
    Mesh mesh;                ///< no indices if the list has no complete primitive
    std::size_t dropped = 0;  ///< number of vertices of an incomplete last primitive
    /// The colour of all vertices if it is the same; the mesh then has no colour attribute.
    std::optional<std::array<double, 4>> color;
};

/// Makes the mesh of a glBegin list. Strips, loops, fans, polygons and quads are split into separate
/// primitives. The last corner of each triangle is the one from which GL takes flat colours. All vertices are
/// kept, in their order.
///
/// Normals are used as given if `hasNormals` is set. Otherwise separate triangles and quads get face normals;
/// strips, fans and polygons get the area-weighted mean at each vertex; everything else, and faces without
/// area, get (0, 0, 1). For homogeneous points the normals are those of the points divided by w. Tangents are
/// T0(N). Texture coordinates that are (0, 0, 0, 1) at all vertices are left out, since a missing attribute
/// reads the same. Positions have four components only if some w is not 1. patchVertices, 1 to 32, is used
/// for patches only.
ListMesh meshFromList(ListTopology topology, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices);
/// The same, with the topology as a word that listTopology knows.
ListMesh meshFromList(std::string_view topologyWord, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices);

/// Makes the mesh of the command Triangles: every three points (x, y, z, w) are a triangle with the normal of
/// its face and (s, t) = (0, 0), (1, 0), (0, 1). The number of points must be a multiple of 3.
Mesh trianglesList(std::span<const std::array<double, 4>> points);

/// Makes the mesh of the command LinesAdjacency: every four points are a line with adjacency; normals are
/// (0, 0, 1), and there are no texture coordinates. The number of points must be a multiple of 4.
Mesh linesAdjacencyList(std::span<const std::array<double, 4>> points);

}  // namespace glibra::geometry
