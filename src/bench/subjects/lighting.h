#pragma once
// Light on a sphere and a torus, evaluated in double at the point that a pixel's ray meets: the reference for
// drawn lighting. Eye space: rays run along -z through (x, y); the direction to the viewer is (0, 0, 1)
// everywhere.

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "bench/core/bench.h"

namespace glibra::bench {

enum class LitSurface { sphere, torus };

inline constexpr double kRingRadius = .7, kTubeRadius = .3;
/// The rotation of the torus out of the plane XY, to eye space.
glm::dmat3 torusRotation();

/// The unit normal where the ray through (x, y) first meets the unit sphere or the torus (of kRingRadius and
/// kTubeRadius, turned by torusRotation); nothing if the ray misses it.
std::optional<glm::dvec3> normalAt(LitSurface surface, double x, double y);

enum class Highlight {
    reflection,  ///< Phong 1975: reflected light and direction to the viewer
    halfVector   ///< Blinn 1977: normal and the direction halfway between light and viewer
};

/// max(0, cosine)^exponent; 0 if the light is behind the surface. `light` points to the light and has unit
/// length.
double highlight(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent);

/// Ambient + diffuse + highlight, which add up to 1.
double intensity(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent);

std::vector<Figure> measureLighting(Bench& bench);

}  // namespace glibra::bench
