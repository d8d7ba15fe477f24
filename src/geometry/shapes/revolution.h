#pragma once
// Bands, caps and rings of surfaces of revolution, from which cylinders, cones, disks and arrows are made.

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

/// A straight profile from (startAlong, startRadius) to (endAlong, endRadius), in equal rows with t from
/// startT to endT. endRadius 0 makes an apex, which holds one vertex a slice.
struct Band {
    double startAlong = 0, startRadius = 0, startT = 0;
    double endAlong = 0, endRadius = 0, endT = 1;
    int rows = 1;
    bool apex = false;
};

/// A flat disk or ring across the axis. s and t are the coordinates along sDirection and tDirection, 0..1
/// across the outer radius; the normal is sDirection x tDirection, +along or -along.
struct Cap {
    double along = 0, radius = 0;
    glm::dvec3 sDirection, tDirection;
};

/// The point of that ring, the same bits whatever surface it belongs to. `circle` is (cos, sin) of 2 pi s.
glm::dvec3 ringPoint(const Axis& axis, double along, double radius, const glm::dvec2& circle);

/// Vertices of the band, row after row. `circle` is unitCircle(slices). Normals point away from the axis, s
/// and t directions and normal are right-handed.
void addBandPoints(Surface& surface, const Axis& axis, const Band& band, std::span<const glm::dvec2> circle);
void addBandCells(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices);
void addBandEdges(Surface& surface, std::uint32_t base, const Band& band, std::uint32_t slices);

/// Vertices of a cap: the centre once a slice, then `rings` circles at equal steps of the radius; and its
/// triangles.
void addCap(Surface& surface, const Axis& axis, const Cap& cap, int rings,
            std::span<const glm::dvec2> circle);

/// The part of a cap with normal -along outside innerRadius, one cell wide: inner circle, outer circle,
/// cells.
void addBackRing(Surface& surface, const Axis& axis, const Cap& cap, double innerRadius,
                 std::span<const glm::dvec2> circle);

}  // namespace glibra::geometry
