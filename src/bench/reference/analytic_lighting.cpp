#include "bench/reference/analytic_lighting.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

namespace glibra::bench {
namespace {

std::optional<glm::dvec3> sphereNormal(double x, double y) {
    const double zSquared = 1 - x * x - y * y;
    if (zSquared < 0) return std::nullopt;
    return glm::dvec3(x, y, std::sqrt(zSquared));
}

/// Signed distance from the torus around the z axis.
double torusDistance(const glm::dvec3& p) {
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - kRingRadius, p.z)) - kTubeRadius;
}

/// Sphere tracing: steps as long as the distance never pass through the surface (Hart 1996).
std::optional<glm::dvec3> torusNormal(double x, double y) {
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

}  // namespace

glm::dmat3 torusRotation() {
    constexpr double kAngle = 50 * std::numbers::pi / 180;
    const double c = std::cos(kAngle), s = std::sin(kAngle);
    return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
}

std::optional<glm::dvec3> normalAt(LitSurface surface, double x, double y) {
    return surface == LitSurface::sphere ? sphereNormal(x, y) : torusNormal(x, y);
}

double highlight(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    const glm::dvec3 viewer(0, 0, 1);
    const double facing = glm::dot(normal, light);
    if (facing <= 0) return 0;
    const double cosine = model == Highlight::reflection ? glm::dot(2 * facing * normal - light, viewer)
                                                         : glm::dot(normal, glm::normalize(light + viewer));
    return std::pow(std::max(cosine, 0.0), exponent);
}

double intensity(Highlight model, const glm::dvec3& normal, const glm::dvec3& light, double exponent) {
    return kAmbient + kDiffuse * std::max(glm::dot(normal, light), 0.0) +
           kSpecular * highlight(model, normal, light, exponent);
}

}  // namespace glibra::bench
