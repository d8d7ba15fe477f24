#pragma once
// A density over the unit cube, most of it empty, and the light along rays through it, computed in double:
// the reference for what a shader integrates.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// side^3 texels, x fastest, 0..1. The density is trilinear between texel centres and constant beyond the
/// outermost ones.
struct VolumeField {
    int side = 0;
    std::vector<float> texels;

    [[nodiscard]] double at(const glm::dvec3& p) const;
    /// The index of texel (x, y, z) in `texels`.
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(side) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(side) +
               static_cast<std::size_t>(x);
    }
};

/// Three round blobs of limited size and a hollow shell, with empty space between them.
VolumeField blobs(int side);

/// The largest density in each block of blockSide^3 texels, including the neighbouring texels that the filter
/// reads there: 0 means that a sample anywhere in the block is exactly 0. The result has side field.side /
/// blockSide.
VolumeField blockMaxima(const VolumeField& field, int blockSide);

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
VolumeView volumeView();
std::optional<VolumeRay> volumeRay(double x, double y);

/// Light and opacity: the integral of extinction * colour * transmittance, and 1 - the total transmittance.
/// Extinction is strength * density; colour is .2 + .8 density.
struct VolumeLight {
    double light = 0, opacity = 0;
};

/// The midpoint rule with `steps` steps along the cube's diagonal; shorter rays have proportionally fewer.
VolumeLight integrate(const VolumeField& field, const VolumeRay& ray, double strength, int steps);

std::vector<Figure> measureVolume(Bench& bench);

}  // namespace glibra::bench
