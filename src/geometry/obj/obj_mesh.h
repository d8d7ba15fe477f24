#pragma once
// Meshes of OBJ models. Positions are those of the file; nothing is moved or scaled.

#include "geometry/mesh.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

/// Makes triangles: a polygon with n corners becomes the fan (0, i, i + 1), or, if that leaves its outline,
/// n - 2 other triangles (concave_faces.h). Each different triple (v, vt, vn) becomes one vertex, in the
/// order of first use.
///
/// Normals are those of the file, made unit vectors; a corner without a normal, or with one of length zero,
/// gets the area-weighted mean of the faces around its position index. In a file with `s` lines these are the
/// faces of its smoothing group, or, for `s off`, its own face alone; a vertex then belongs to one group, or
/// to one such face. Texture coordinates are left out if
/// the file has none; a corner without one has (0, 0, 0). Tangents are the directions of rising t, weighted
/// by area over the triangles at the vertex and made perpendicular to the normal, or T0(N) where they are
/// undefined. Colours are those of the `v` lines, or left out. `withTangents` is false for a draw whose
/// program reads no tangents; the mesh then has none.
Mesh obj(const ObjModel& model, bool withTangents = true);

/// Makes the same vertices and triangles, as patches of 3 vertices.
Mesh objPatch(const ObjModel& model, bool withTangents = true);

/// Makes the same triangles with adjacency: the corners are at 0, 2, 4, and at 1, 3, 5 are the far corners of
/// the neighbours across 0-2, 2-4, 4-0. Two edges are the same if their ends have equal coordinates. An edge
/// that has no neighbour, or no length, has its own first vertex there; an edge shared by three or more
/// triangles has the first other one in file order.
Mesh objAdj(const ObjModel& model, bool withTangents = true);

/// Makes the same vertices, with each edge of the file's polygons once as a line. Edges are told apart by
/// their position indices and stand in the order of first use; those of `l` lines follow, then the points of
/// `p` lines (Mesh::pointCount).
Mesh wireObj(const ObjModel& model, bool withTangents = true);

}  // namespace glibra::geometry
