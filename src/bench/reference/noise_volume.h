#pragma once
// Three-dimensional noise textures in several texel formats, interpolated in double, and their exact values.

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/packing.hpp>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "gpu/format/texels.h"
#include "noise/noise.h"

namespace glibra::bench {

struct NoiseFormat {
    std::string_view name;
    gpu::TexelFormat texels;
    double steps = 0;       ///< of the values 0..1 that it keeps; 0: floats
    bool isCutOff = false;  ///< as in scenes (noise::noise3Texels), otherwise rounded to nearest
};
inline constexpr std::array<NoiseFormat, 5> kNoiseFormats{
    {{"8 bit, cut off", gpu::TexelFormat::rgba8, 255, true},
     {"8 bit, rounded", gpu::TexelFormat::rgba8, 255},
     {"16 bit", gpu::TexelFormat::rgba16, 65535},
     {"half float", gpu::TexelFormat::rgba16f},
     {"float", gpu::TexelFormat::rgba32f}}};

/// One value per octave.
using Octaves = std::array<double, noise::kOctaves>;
/// The function itself; the place is in periods.
inline Octaves exactNoise(const glm::dvec3& place) {
    Octaves values{};
    for (int octave = 0; octave < noise::kOctaves; ++octave) {
        const glm::dvec3 lattice = place * static_cast<double>(noise::cellsOf(octave));
        values[static_cast<std::size_t>(octave)] = noise::noise3(lattice.x, lattice.y, lattice.z, octave);
    }
    return values;
}

/// n x n x n texels of the exact function as floats: x fastest, four octaves per texel.
inline std::vector<float> exactTexels(int n) {
    std::vector<float> texels;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x)
                for (const double each : exactNoise(glm::dvec3(x, y, z) / static_cast<double>(n)))
                    texels.push_back(static_cast<float>(each));
    return texels;
}

class NoiseVolume {
  public:
    /// `exact`: exactTexels(n), unused for a format that is cut off.
    NoiseVolume(int n, const NoiseFormat& format, const std::vector<float>& exact) : n_(n), format_(format) {
        if (format.isCutOff)
            for (const std::uint8_t byte : noise::noise3Texels(n))
                values_.push_back(static_cast<float>(byte / format.steps));
        else
            for (const float value : exact)
                values_.push_back(format.steps > 0
                                      ? static_cast<float>(std::round(value * format.steps) / format.steps)
                                  : format.texels == gpu::TexelFormat::rgba16f
                                      ? glm::unpackHalf1x16(glm::packHalf1x16(value))
                                      : value);
    }

    /// Interpolates trilinearly in double; the texture repeats. Texel i stands for the place i / n.
    [[nodiscard]] Octaves at(const glm::dvec3& place) const {
        std::array<std::array<std::size_t, 2>, 3> index{};
        glm::dvec3 share;
        const auto side = static_cast<std::size_t>(n_);
        for (int axis = 0; axis < 3; ++axis) {
            const double texel = (place[axis] - std::floor(place[axis])) * n_;
            const auto near = static_cast<std::size_t>(texel);
            share[axis] = texel - static_cast<double>(near);
            index[static_cast<std::size_t>(axis)] = {near % side, (near + 1) % side};
        }
        Octaves sum{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
            const double weight =
                (i ? share.x : 1 - share.x) * (j ? share.y : 1 - share.y) * (k ? share.z : 1 - share.z);
            const float* texel =
                values_.data() + ((index[2][k] * side + index[1][j]) * side + index[0][i]) * noise::kOctaves;
            for (std::size_t octave = 0; octave < sum.size(); ++octave) sum[octave] += weight * texel[octave];
        }
        return sum;
    }

    [[nodiscard]] int side() const { return n_; }
    [[nodiscard]] const NoiseFormat& format() const { return format_; }
    [[nodiscard]] const std::vector<float>& values() const { return values_; }

  private:
    int n_;
    NoiseFormat format_;
    std::vector<float> values_;  ///< as the format stores them
};

/// Point i of a sequence that fills the unit cube evenly (M. Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
inline glm::dvec3 spread(int i) {
    constexpr double kRoot = 1.2207440846057596;  // of x^4 = x + 1
    glm::dvec3 place(.5);
    double step = 1;
    for (int axis = 0; axis < 3; ++axis) {
        step /= kRoot;
        place[axis] += step * i;
        place[axis] -= std::floor(place[axis]);
    }
    return place;
}

}  // namespace glibra::bench
