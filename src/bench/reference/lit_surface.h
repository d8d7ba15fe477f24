#pragma once
// Light on a sphere and a torus, evaluated in double at the point that a pixel's ray meets: the reference for
// drawn lighting. Eye space: rays run along -z through (x, y); the direction to the viewer is (0, 0, 1)
// everywhere.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>

namespace glibra::bench {

enum class LitSurface { sphere, torus };

inline constexpr double kRingRadius = .7, kTubeRadius = .3;

/// The rotation of the torus out of the plane XY, to eye space.
inline glm::dmat3 torusRotation() {
    constexpr double kAngle = 50 * std::numbers::pi / 180;
    const double c = std::cos(kAngle), s = std::sin(kAngle);
    return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
}

/// Signed distance from the torus around the z axis.
inline double torusDistance(const glm::dvec3& p) {
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - kRingRadius, p.z)) - kTubeRadius;
}

/// The unit normal where the ray through (x, y) first meets the unit sphere or the torus (of kRingRadius and
/// kTubeRadius, turned by torusRotation); nothing if the ray misses it.
inline std::optional<glm::dvec3> normalAt(LitSurface surface, double x, double y) {
    if (surface == LitSurface::sphere) {
        const double zSquared = 1 - x * x - y * y;
        return zSquared < 0 ? std::nullopt : std::optional(glm::dvec3(x, y, std::sqrt(zSquared)));
    }
    // Sphere tracing: steps as long as the distance never pass through the surface (Hart 1996).
    constexpr double kHit = 1e-12, kReach = 1.5;
    constexpr int kMostSteps = 2000;
    const glm::dmat3 toModel = glm::transpose(torusRotation());
    const glm::dvec3 direction = toModel * glm::dvec3(0, 0, -1);
    glm::dvec3 p = toModel * glm::dvec3(x, y, kReach);
    double travelled = 0;
    for (int i = 0; i < kMostSteps && travelled < 2 * kReach; ++i) {
        const double step = torusDistance(p);
        if (step < kHit) {
            const glm::dvec2 ring = glm::normalize(glm::dvec2(p)) * kRingRadius;
            return glm::transpose(toModel) * glm::normalize(p - glm::dvec3(ring, 0));
        }
        p += direction * step;
        travelled += step;
    }
    return std::nullopt;
}

enum class Highlight {
    reflection,  ///< Phong 1975: reflected light and direction to the viewer
    halfVector   ///< Blinn 1977: normal and the direction halfway between light and viewer
};

/// max(0, cosine)^exponent; 0 if the light is behind the surface. `light` points to the light and has unit
/// length.
inline double highlight(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    const glm::dvec3 viewer(0, 0, 1);
    const double facing = glm::dot(normal, light);
    if (facing <= 0) return 0;
    const double cosine = model == Highlight::reflection ? glm::dot(2 * facing * normal - light, viewer)
                                                         : glm::dot(normal, glm::normalize(light + viewer));
    return std::pow(std::max(cosine, 0.0), exponent);
}

/// Ambient + diffuse + highlight, which add up to 1.
inline double intensity(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    return .1 + .5 * std::max(glm::dot(normal, light), 0.0) + .4 * highlight(model, normal, light, exponent);
}

}  // namespace glibra::bench
