#pragma once
// Light in double: the reference for drawn lighting, on surfaces and in volumes.

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace glibra::bench {

// Light on a sphere and a torus, evaluated in double at the point that a pixel's ray meets: the reference for
// drawn lighting. Eye space: rays run along -z through (x, y); the direction to the viewer is (0, 0, 1)
// everywhere.

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

// A density over the unit cube, most of it empty, and the light along rays through it, computed in double:
// the reference for what a shader integrates.

/// side^3 texels, x fastest, 0..1. The density is trilinear between texel centres and constant beyond the
/// outermost ones.
struct VolumeField {
    int side = 0;
    std::vector<float> texels;

    /// The index of texel (x, y, z) in `texels`.
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(side) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(side) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] double at(const glm::dvec3& p) const {
        std::array<int, 3> low{}, high{};
        glm::dvec3 t;
        for (int axis = 0; axis < 3; ++axis) {
            const double place = std::clamp(p[axis] * side - .5, 0.0, side - 1.0);
            const int texel = std::min(static_cast<int>(place), side - 1);
            low[static_cast<std::size_t>(axis)] = texel;
            high[static_cast<std::size_t>(axis)] = std::min(texel + 1, side - 1);
            t[axis] = place - texel;
        }
        const auto texel = [&](int x, int y, int z) { return static_cast<double>(texels[index(x, y, z)]); };
        const auto row = [&](int y, int z) {
            return std::lerp(texel(low[0], y, z), texel(high[0], y, z), t.x);
        };
        const auto layer = [&](int z) { return std::lerp(row(low[1], z), row(high[1], z), t.y); };
        return std::lerp(layer(low[2]), layer(high[2]), t.z);
    }
};

/// 1 in the middle, 0 from distance 1 on, with a continuous slope.
inline double bump(double distance) {
    const double inside = std::max(0.0, 1 - distance * distance);
    return inside * inside;
}

/// Three round blobs of limited size and a hollow shell, with empty space between them.
inline double blobDensity(const glm::dvec3& p) {
    const auto from = [&](double x, double y, double z) { return glm::length(p - glm::dvec3(x, y, z)); };
    return std::min(1.0, .9 * bump(from(.3, .35, .4) / .16) + .7 * bump(from(.7, .3, .65) / .2) +
                             bump(from(.4, .75, .3) / .12) + .5 * bump((from(.65, .7, .6) - .14) / .05));
}

inline VolumeField blobs(int side) {
    VolumeField field{side, {}};
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                field.texels.push_back(
                    static_cast<float>(blobDensity((glm::dvec3(x, y, z) + .5) / static_cast<double>(side))));
    return field;
}

/// The largest density in each block of blockSide^3 texels, including the neighbouring texels that the filter
/// reads there: 0 means that a sample anywhere in the block is exactly 0. The result has side field.side /
/// blockSide.
inline VolumeField blockMaxima(const VolumeField& field, int blockSide) {
    VolumeField blocks{field.side / blockSide, {}};
    blocks.texels.assign(blocks.index(0, 0, blocks.side), 0);
    // At the rim of a block, the filter reads one texel beyond it.
    const auto first = [&](int block) { return std::max(block * blockSide - 1, 0); };
    const auto last = [&](int block) { return std::min((block + 1) * blockSide, field.side - 1); };
    for (int bz = 0; bz < blocks.side; ++bz)
        for (int by = 0; by < blocks.side; ++by)
            for (int bx = 0; bx < blocks.side; ++bx) {
                float& most = blocks.texels[blocks.index(bx, by, bz)];
                for (int z = first(bz); z <= last(bz); ++z)
                    for (int y = first(by); y <= last(by); ++y)
                        for (int x = first(bx); x <= last(bx); ++x)
                            most = std::max(most, field.texels[field.index(x, y, z)]);
            }
    return blocks;
}

/// The part of a ray inside the cube: origin + t direction for enter <= t <= leave.
struct VolumeRay {
    glm::dvec3 origin, direction;
    double enter = 0, leave = 0;
};

/// The rays are parallel; their direction is not an axis of the cube. (x, y) in -1..1 span a square that
/// holds the whole cube.
inline constexpr double kVolumeSeen = .87;  ///< half the side of that square, in cube sides
struct VolumeView {
    glm::dvec3 right, up, direction;
};
inline VolumeView volumeView() {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(.45, -.3, -1));
    const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(0, 1, 0)));
    return {right, glm::cross(right, direction), direction};
}

inline std::optional<VolumeRay> volumeRay(double x, double y) {
    const VolumeView view = volumeView();
    VolumeRay ray{glm::dvec3(.5) + kVolumeSeen * (x * view.right + y * view.up), view.direction, -10, 10};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = -ray.origin[axis] / ray.direction[axis];
        const double b = (1 - ray.origin[axis]) / ray.direction[axis];
        ray.enter = std::max(ray.enter, std::min(a, b));
        ray.leave = std::min(ray.leave, std::max(a, b));
    }
    if (ray.enter >= ray.leave) return std::nullopt;
    return ray;
}

/// Light and opacity: the integral of extinction * colour * transmittance, and 1 - the total transmittance.
/// Extinction is strength * density; colour is .2 + .8 density.
struct VolumeLight {
    double light = 0, opacity = 0;
};

/// The midpoint rule with `steps` steps along the cube's diagonal; shorter rays have proportionally fewer.
inline VolumeLight integrate(const VolumeField& field, const VolumeRay& ray, double strength, int steps) {
    const double length = ray.leave - ray.enter;
    const int count = std::max(1, static_cast<int>(std::ceil(length * steps / std::numbers::sqrt3)));
    const double step = length / count;
    double light = 0, transmittance = 1;
    for (int i = 0; i < count; ++i) {
        const double density = field.at(ray.origin + (ray.enter + (i + .5) * step) * ray.direction);
        if (density == 0) continue;
        const double kept = std::exp(-strength * density * step);
        light += transmittance * (1 - kept) * (.2 + .8 * density);
        transmittance *= kept;
    }
    return {light, 1 - transmittance};
}

}  // namespace glibra::bench
