#pragma once
// How far meshes lie from curved surfaces: the formulas that several primitives share.
//
// Fidelity::shape: a chord of a circle of radius r that is cut into n parts lies r (1 - cos(pi/n)) inside it.
// Fidelity::pattern: on a triangle that spans ds, dt of the parameters, linear interpolation is off by no
// more than (ds^2 |P_ss| + 2 ds dt |P_st| + dt^2 |P_tt|) / 8 (Filip, Magedson, Markot: Surface algorithms
// using bounds on derivatives, Computer Aided Geometric Design 3, 1986, theorem 1). This is larger than the
// first where cells are twisted: the diagonals of a sphere's cells shear what is painted on them.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "geometry/shapes/primitive.h"

namespace glibra::geometry {

/// Slices of 10 degrees: diffuse light, a cosine, is off by (pi/18)^2 / 8 = 0.97/255 where it is
/// interpolated.
inline constexpr int kSmoothTurn = 36;

inline double chordDeviation(double radius, double slices) {
    return radius * (1 - std::cos(std::numbers::pi / slices));
}

/// For a sphere or a part of one. The cells span the angles `around` and `along`, radians. The quads are
/// planar; the planes of the row at the equator, or next to it, lie furthest inside, at least
/// radius cos(around/2) cos(along/2) from the centre.
inline double ballDeviation(double radius, double around, double along, Fidelity fidelity) {
    if (fidelity == Fidelity::shape) return radius * (1 - std::cos(around / 2) * std::cos(along / 2));
    // |P_ss| = cos f, |P_sf| = |sin f|, |P_ff| = 1 at the latitude f: the largest sum over f.
    const double square = around * around;
    return radius / 8 * (along * along + std::hypot(square, 2 * around * along));
}

/// For the side of a cone. The rows narrow toward the apex, which twists the cells.
inline double coneSideDeviation(double radius, double slices, double stacks, Fidelity fidelity) {
    const double around = 2 * std::numbers::pi / slices;
    return fidelity == Fidelity::shape ? chordDeviation(radius, slices)
                                       : radius / 8 * (around * around + 2 * around / stacks);
}

inline Extent boxExtent(const glm::dvec3& low, const glm::dvec3& high) {
    return {low, high, glm::length(high - low) / 2};
}
inline Extent ballExtent(double radius) {
    return {glm::dvec3(-radius), glm::dvec3(radius), radius};
}
/// For a cylinder or a cone on the plane y = 0.
inline Extent standingExtent(double radius, double height) {
    return boxExtent({-radius, 0, -radius}, {radius, height, radius});
}

}  // namespace glibra::geometry
