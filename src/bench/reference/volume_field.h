#pragma once
// A density over the unit cube, most of it empty, and the light that rays through it bring to the eye: in
// double, for comparison with what a shader integrates.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace glibra::bench {

/// side^3 texels, x fastest, 0..1. Between texel centres the density is trilinear, beyond the outermost it is
/// constant.
struct VolumeField {
    int side = 0;
    std::vector<float> texels;

    [[nodiscard]] double at(const glm::dvec3& p) const;
    /// Where texel (x, y, z) stands in `texels`.
    [[nodiscard]] std::size_t index(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(side) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(side) +
               static_cast<std::size_t>(x);
    }
};

/// Three round blobs of bounded size and a hollow shell, with nothing between them.
VolumeField blobs(int side);

/// The largest density of each block of `blockSide` texels a side, its neighbours' texels that the filter
/// reads there included: 0 means that a sample anywhere in the block is exactly 0. Side: field.side /
/// blockSide.
VolumeField blockMaxima(const VolumeField& field, int blockSide);

/// Where a ray is inside the cube: origin + t direction for enter <= t <= leave.
struct VolumeRay {
    glm::dvec3 origin, direction;
    double enter = 0, leave = 0;
};

/// Rays are parallel, along a direction that is no axis of the cube. (x, y) in -1..1 span a square that holds
/// the whole cube.
inline constexpr double kVolumeSeen = .87;  ///< half the side of that square, cube sides
struct VolumeView {
    glm::dvec3 right, up, direction;
};
VolumeView volumeView();
std::optional<VolumeRay> volumeRay(double x, double y);

/// Light and opacity: the integral of extinction * colour * transmittance, and 1 - the transmittance of the
/// whole. Extinction is strength * density, colour .2 + .8 density.
struct VolumeLight {
    double light = 0, opacity = 0;
};

/// The midpoint rule with `steps` steps for the cube's diagonal, shorter rays in proportion.
VolumeLight integrate(const VolumeField& field, const VolumeRay& ray, double strength, int steps);

}  // namespace glibra::bench
