#pragma once
// Polygons in space as outlines in a plane, and exact orientations there.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

/// A point of a plane; its coordinates are floats of a model.
struct PlanePoint {
    float x = 0, y = 0;
    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// 1 if a, b, c turn left (counterclockwise), -1 if they turn right, 0 if they lie on a line. Exact for all
/// finite floats.
int orientation(PlanePoint a, PlanePoint b, PlanePoint c);

/// The axis to which a vector is nearest: 0, 1, 2 for x, y, z. Of axes that are about equally near, the last.
int nearestAxis(const glm::dvec3& vector);

/// The polygon seen along the x, y or z axis: the one to which its area vector is nearest. A polygon without
/// an area vector, as a bow tie, is seen along the axis along which its turns are widest.
std::vector<PlanePoint> planeOutline(std::span<const Triple> polygon);

}  // namespace glibra::geometry
