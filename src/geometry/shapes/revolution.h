#pragma once
// Parts of surfaces of revolution: bands, caps and rings. Cylinders, cones, disks and arrows consist of them.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "geometry/shapes/surface.h"

namespace glibra::geometry {

/// A right-handed frame: zero x quarter = along. All three are unit vectors along coordinate axes.
struct Axis {
    glm::dvec3 along;    ///< the axis of revolution
    glm::dvec3 zero;     ///< where s = 0
    glm::dvec3 quarter;  ///< where s = 1/4
};

/// The axis of shapes that stand on the plane y = 0.
inline const Axis kStanding{.along = {0, 1, 0}, .zero = {-1, 0, 0}, .quarter = {0, 0, 1}};

/// A straight profile from (startAlong, startRadius) to (endAlong, endRadius), in equal rows with t from
/// startT to endT. If `apex` is set, endRadius is 0, and the apex has one vertex per slice.
struct Band {
    double startAlong = 0, startRadius = 0, startT = 0;
    double endAlong = 0, endRadius = 0, endT = 1;
    int rows = 1;
    bool apex = false;
};

/// A flat disk or ring across the axis. s and t are the coordinates along sDirection and tDirection, from 0
/// to 1 across the outer circle. The normal is sDirection x tDirection, which is +along or -along.
struct Cap {
    double along = 0, radius = 0;
    glm::dvec3 sDirection, tDirection;
};

/// Returns the point of a ring. It has the same bits whatever surface it belongs to. `circle` is (cos, sin)
/// of 2 pi s.
glm::dvec3 ringPoint(const Axis& axis, double along, double radius, const glm::dvec2& circle);

/// Adds the vertices of the band, row after row. `circle` is unitCircle(slices). Normals point away from the
/// axis; the direction of s, the direction of t and the normal are right-handed.
void addBandPoints(Surface& surface, const Axis& axis, const Band& band, std::span<const glm::dvec2> circle);
void addBandCells(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices);
void addBandEdges(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices);

/// Adds a cap: the centre once per slice, then `rings` circles at equal steps of the radius, and the
/// triangles.
void addCap(Surface& surface, const Axis& axis, const Cap& cap, int rings,
            std::span<const glm::dvec2> circle);

/// Adds the part of a cap outside innerRadius, one cell wide: inner circle, outer circle, cells. The cap's
/// normal is -along.
void addBackRing(Surface& surface, const Axis& axis, const Cap& cap, double innerRadius,
                 std::span<const glm::dvec2> circle);

}  // namespace glibra::geometry
