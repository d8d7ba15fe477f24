#pragma once
// Meshes of OBJ models. Positions are those of the file, neither moved nor scaled.

#include "geometry/mesh.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

/// Triangles: a polygon with n corners becomes the fan (0, i, i + 1). One vertex for each different triple
/// (v, vt, vn), in the order of first use. Normals are those of the file made unit; a corner without one, or
/// with one of length zero, gets the area-weighted mean of the faces around its position index. Texture
/// coordinates are left out if the file has none; a corner without one has (0, 0, 0). Tangents are the
/// directions of growing t, area-weighted over the triangles at the vertex and perpendicular to the normal,
/// T0(N) where they are undefined; without `withTangents` there is no such attribute (for a draw whose
/// program reads none).
Mesh obj(const ObjModel& model, bool withTangents = true);

/// The same vertices and triangles as 3-vertex patches.
Mesh objPatch(const ObjModel& model, bool withTangents = true);

/// The same triangles with adjacency: corners at 0, 2, 4; at 1, 3, 5 the far corners of the neighbours across
/// 0-2, 2-4, 4-0. Edges are the same if their ends have equal coordinates. Across a border edge, or one of no
/// length, lies the edge's own first vertex; across an edge of three or more triangles the first other one in
/// file order.
Mesh objAdj(const ObjModel& model, bool withTangents = true);

/// The same vertices; every edge of the file's polygons once, by position index, in the order of first use.
Mesh wireObj(const ObjModel& model, bool withTangents = true);

}  // namespace glibra::geometry
