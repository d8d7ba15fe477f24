#pragma once
// Meshes whose vertices stand in the scene's text: glBegin lists, Triangles, LinesAdjacency.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "geometry/list_topology.h"
#include "geometry/mesh.h"

namespace glibra::geometry {

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
