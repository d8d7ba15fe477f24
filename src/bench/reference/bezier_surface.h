#pragma once
// A bicubic patch in double by de Casteljau's scheme, and the distance from it: the reference for the teapot.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/shapes/teapot_patches.h"

namespace glibra::bench {

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< and the derivatives by s and t
};

/// By repeated linear interpolation, in another order of operations than Bernstein polynomials take.
PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st);

/// The parameters, within 0..1, of the point of the patch nearest to `point` in the neighbourhood of `start`
/// (Gauss-Newton steps with damping).
glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start);

}  // namespace glibra::bench
