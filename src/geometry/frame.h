#pragma once
// Directions that all shapes share: exact points of the unit circle, and a tangent where no texture gives
// one.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace glibra::geometry {

/// (cos, sin) of 2 pi i / n for 0 <= i <= n, n >= 1. The angle is reduced to an eighth of a turn in integers,
/// so that quarter turns are exact, mirrored points are mirrored bit for bit, and i = n gives what i = 0
/// gives. Never -0.
glm::dvec2 unitTurn(std::int64_t i, std::int64_t n);

/// All n + 1 of them; the last is the first.
std::vector<glm::dvec2> unitCircle(int n);

/// T0(N): the unit part of +y perpendicular to the normal; (0, 0, -1) for a normal along +y, (0, 0, 1) along
/// -y. The normal need not be of unit length; a zero or not finite one gives (0, 1, 0).
glm::dvec3 fallbackTangent(const glm::dvec3& normal);

/// v / |v|, or `otherwise` where that is not finite. Neither overflows nor underflows on the way.
glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise);

}  // namespace glibra::geometry
