#pragma once
// The vertices that the corners of a model's polygons become.

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

struct ObjVertices {
    std::vector<std::uint32_t> ofCorner;  ///< the vertex of each corner
    std::vector<ObjCorner> corners;       ///< the triple (v, vt, vn) of each vertex
};

/// Makes one vertex per different triple, in the order of first use.
ObjVertices objVertices(const ObjModel& model);

/// Returns three vertices for each triangle of the polygons' fans.
std::vector<std::uint32_t> fanIndices(const ObjModel& model, const ObjVertices& vertices);

/// Returns position, normal, texture coordinate (if the model has any) and, if wanted, tangent of each
/// vertex, as described in obj_mesh.h.
std::vector<Attribute> objAttributes(const ObjModel& model, const ObjVertices& vertices,
                                     const std::vector<std::uint32_t>& triangles, bool withTangents);

}  // namespace glibra::geometry
