#pragma once
// The topologies of glBegin, and how they split a list of vertices into separate primitives.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "geometry/mesh.h"

namespace glibra::geometry {

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

}  // namespace glibra::geometry
