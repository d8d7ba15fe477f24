#pragma once
// The vertices that the corners of a model's polygons become.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

struct ObjVertices {
    std::vector<std::uint32_t> ofCorner;  ///< the vertex of each corner of a face
    std::vector<std::uint32_t> ofLineCorner, ofPoint;
    std::vector<ObjCorner> corners;  ///< the triple (v, vt, vn) of each vertex
    /// The normals that corners without one get from their smoothing groups. They are numbered after those of
    /// the model.
    std::vector<glm::dvec3> groupNormals;
};

/// Makes one vertex per different triple, in the order of first use. In a file with `s` lines, a corner
/// without a normal has one of groupNormals.
ObjVertices objVertices(const ObjModel& model);

/// Returns three vertices for each triangle of the polygons: fans, and what the model says of its splitFaces.
std::vector<std::uint32_t> triangleIndices(const ObjModel& model, const ObjVertices& vertices);

/// Returns position, normal, texture coordinate and colour (if the model has any) and, if wanted, tangent of
/// each vertex, as described in obj_mesh.h.
std::vector<Attribute> objAttributes(const ObjModel& model, const ObjVertices& vertices,
                                     const std::vector<std::uint32_t>& triangles, bool withTangents);

}  // namespace glibra::geometry
