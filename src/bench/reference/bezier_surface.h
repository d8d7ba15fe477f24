#pragma once
// A bicubic patch in double by de Casteljau's algorithm, and the distance from it: the reference for the
// teapot.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "geometry/shapes/teapot.h"

namespace glibra::bench {

using TeapotPatches = std::array<geometry::Patch, 32>;

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< position, and derivatives by s and t
};

/// By repeated linear interpolation, which orders its operations differently from Bernstein polynomials.
PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st);

/// The parameters, within 0..1, of the point of the patch that is nearest to `point`, searched from `start`
/// by damped Gauss-Newton steps.
glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start);

/// The patches of the teapot at their places in the meshes of scenes, whose body is two units wide.
TeapotPatches placedTeapotPatches();

}  // namespace glibra::bench
