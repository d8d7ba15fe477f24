#pragma once
// Bicubic patches in double, and meshes of the teapot against its patches.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "bench/core/bench.h"
#include "geometry/shapes/teapot.h"

namespace glibra::bench {

struct PatchPoint {
    glm::dvec3 position{0}, alongS{0}, alongT{0};  ///< position, and derivatives by s and t
};
/// By de Casteljau's algorithm, which orders its operations differently from Bernstein polynomials.
PatchPoint patchPoint(const geometry::Patch& patch, const glm::dvec2& st);
/// The parameters, within 0..1, of the point of the patch that is nearest to `point`, searched from `start`
/// by damped Gauss-Newton steps.
glm::dvec2 nearestOnPatch(const geometry::Patch& patch, const glm::dvec3& point, glm::dvec2 start);

/// Distance and normals of the teapot's meshes, by the cells per side of a patch. The last point is that of
/// the teapot of scenes.
std::vector<Figure> teapotFigures(const Bench& bench);
/// Soccer ball and teapot by the number of cells along an edge of their faces or patches: distance and
/// normals of the ball; outline and volume of both.
std::vector<Figure> cutShapeFigures(const Bench& bench);

}  // namespace glibra::bench
