#pragma once
// Triangles of polygons that are no fan from their first corner.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/obj/obj_model.h"

namespace glibra::geometry {

// Polygons in space as outlines in a plane, and exact orientations there.

/// A point of a plane; its coordinates are floats of a model.
struct PlanePoint {
    float x = 0, y = 0;
    friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// 1 if a, b, c turn left (counterclockwise), -1 if they turn right, 0 if they lie on a line. Exact for all
/// finite floats.
int orientation(PlanePoint a, PlanePoint b, PlanePoint c);

/// Splits polygons by cutting off ears: G. Meisters, Polygons have ears, The American Mathematical Monthly
/// 82, 1975. Polygons lie in any plane; they are seen along the axis to which their area vector (M. Newell)
/// is nearest. Orientations are exact for all floats.
///
/// The triangles cover the outline and nothing else, with the orientation of the outline, if the outline does
/// not cross itself; it may touch itself, as a face with a hole does that a seam connects with the outer
/// edge. An outline that crosses itself gets triangles too; they depend neither on its first corner nor on
/// its direction. Equal corners, and corners on a straight edge, have triangles without area at worst.
class EarCutter {
  public:
    /// Appends the n - 2 triangles of a polygon with n >= 3 corners, as numbers of its corners. False: they
    /// are the fan from the first corner, because the work for all polygons together exceeds kMostWork.
    bool cut(std::span<const Triple> outline, std::vector<std::uint32_t>& triangles);

    /// Comparisons of a corner with an ear; about two seconds.
    static constexpr std::size_t kMostWork = 300'000'000;

  private:
    std::size_t work_ = 0;
};

/// True if the fan (0, i, i + 1) covers the outline and nothing else: for each convex polygon, and for others
/// if all of the outline can be seen from the first corner. Also true if the outline has no area.
bool isFan(std::span<const Triple> outline);

/// Fills ObjModel::splitFaces and splitTriangles. Returns the number of faces for which the work was too
/// much; they stay fans.
std::size_t splitConcaveFaces(ObjModel& model);

}  // namespace glibra::geometry
