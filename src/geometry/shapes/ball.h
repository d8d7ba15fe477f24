#pragma once
// Parts of spheres: the rings and poles of which spheres, half spheres and capsules consist.

#include <glm/vec2.hpp>
#include <span>

#include "geometry/shapes/surface.h"

namespace glibra::geometry {

/// One ring, or one pole, of a ball around the y axis.
struct BallRing {
    glm::dvec2 latitude{1, 0};  ///< (cos f, sin f)
    double t = 0;
    double centre = 0;  ///< y of the ball's centre
};

/// Adds the vertices of a ring: P = radius (-cos 2 pi s cos f, sin f, sin 2 pi s cos f) from the centre.
/// `circle` is unitCircle(slices).
void addBallRing(Surface& surface, double radius, const BallRing& ring, std::span<const glm::dvec2> circle);

/// Adds a pole: one vertex per slice, with s in the slice's middle.
void addBallPole(Surface& surface, double radius, const BallRing& pole, int slices);

/// Adds the triangles of a closed ball whose vertices begin at 0: the south pole, `rings` rings, the north
/// pole.
void addBallCells(Surface& surface, std::uint32_t rings, std::uint32_t slices);

/// Adds the triangles between a ring and the pole north of it; each is the number of its first vertex.
void addNorthCells(Surface& surface, std::uint32_t ring, std::uint32_t pole, std::uint32_t slices);

}  // namespace glibra::geometry
