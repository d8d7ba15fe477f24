#pragma once
// The vertices that the corners of a model's polygons make.

#include <cstdint>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

struct ObjVertices {
    std::vector<std::uint32_t> ofCorner;  ///< a corner's vertex
    std::vector<ObjCorner> corners;       ///< of each vertex: its triple (v, vt, vn)
};

/// One vertex for each different triple, in the order of first use.
ObjVertices objVertices(const ObjModel& model);

/// Three vertices for each triangle of the polygons' fans.
std::vector<std::uint32_t> fanIndices(const ObjModel& model, const ObjVertices& vertices);

/// Position, normal, texture coordinate (if the model has one) and, if wanted, tangent of each vertex, as
/// obj_mesh.h says.
std::vector<Attribute> objAttributes(const ObjModel& model, const ObjVertices& vertices,
                                     const std::vector<std::uint32_t>& triangles, bool withTangents);

/// For each position the number of the first with equal coordinates; 0 and -0 are equal.
std::vector<std::uint32_t> weldPositions(const std::vector<std::array<float, 3>>& positions);

}  // namespace glibra::geometry
