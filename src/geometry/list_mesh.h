#pragma once
// Meshes from vertices that the scene's text gives: glBegin lists, Triangles, LinesAdjacency.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

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

/// The topology of that word, `triangle_strip` for example, with or without the prefix `gl_`, in any case.
std::optional<ListTopology> listTopology(std::string_view word);

/// What the vertices of a list make: Topology::triangles for strips, fans, polygons and quads, and so on.
Topology meshTopology(ListTopology topology);

/// One vertex of a list, with the state that held at its glVertex.
struct ListVertex {
    std::array<double, 4> position{0, 0, 0, 1};
    std::array<double, 3> normal{0, 0, 1};
    std::array<double, 4> color{1, 1, 1, 1};  ///< red, green, blue, alpha
    std::array<double, 4> texCoord{0, 0, 0, 1};
};

struct ListMesh {
    Mesh mesh;                ///< no indices if the list has no complete primitive
    std::size_t dropped = 0;  ///< vertices of an incomplete last primitive
    /// The colour of all vertices, if they have one in common; the mesh then has no colour attribute.
    std::optional<std::array<double, 4>> color;
};

/// The mesh of a glBegin list. Strips, loops, fans, polygons and quads are split into separate primitives,
/// triangles with the corner last that GL takes flat colours from; all vertices stay, in their order. Normals
/// are passed on as given if `hasNormals`; otherwise separate triangles and quads get face normals, strips,
/// fans and polygons the area-weighted mean at each vertex, all others (0, 0, 1), and so do faces without
/// area. Normals of homogeneous points are those of the points divided by w. Tangents are T0(N). Attributes
/// that are the same everywhere and read the same when left out (texture coordinate 0 0 0 1) are left out;
/// positions have four components only if some w is not 1. patchVertices, 1 to 32, counts for patches only.
ListMesh meshFromList(ListTopology topology, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices);
/// The same by the topology's word, which listTopology must know.
ListMesh meshFromList(std::string_view topologyWord, std::span<const ListVertex> vertices, bool hasNormals,
                      int patchVertices);

/// The command Triangles: every three points (x, y, z, w) a triangle, with the normal of its face and (s, t)
/// = (0, 0), (1, 0), (0, 1). The number of points is a multiple of 3.
Mesh trianglesList(std::span<const std::array<double, 4>> points);

/// The command LinesAdjacency: every four points a line with adjacency, normal (0, 0, 1), no texture
/// coordinate. The number of points is a multiple of 4.
Mesh linesAdjacencyList(std::span<const std::array<double, 4>> points);

}  // namespace glibra::geometry
