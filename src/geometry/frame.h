#pragma once
// Directions that all shapes share: exact points of the unit circle, and tangents where no texture
// coordinates define them.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace glibra::geometry {

/// Returns (cos, sin) of 2 pi i / n for 0 <= i <= n, n >= 1. The angle is reduced to an eighth of a turn in
/// integers, so quarter turns are exact, mirrored points are mirrored bit for bit, and i = n gives the same
/// as i = 0. No component is -0.
glm::dvec2 unitTurn(std::int64_t i, std::int64_t n);

/// Returns all n + 1 points; the last equals the first.
std::vector<glm::dvec2> unitCircle(int n);

/// Returns T0(N): the part of +y that is perpendicular to the normal, made a unit vector; (0, 0, -1) for a
/// normal along +y, (0, 0, 1) for one along -y. The normal may have any length; if it is zero or not finite,
/// the result is (0, 1, 0).
glm::dvec3 fallbackTangent(const glm::dvec3& normal);

/// Returns v / |v|, or `otherwise` if that is not finite. Intermediate values neither overflow nor underflow.
glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise);

}  // namespace glibra::geometry
