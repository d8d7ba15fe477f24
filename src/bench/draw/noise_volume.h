#pragma once
// Three-dimensional noise textures in several texel formats, and their exact values.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/object/texture.h"
#include "noise/noise.h"

namespace glibra::bench {

/// byteFloor is the format in scenes (noise::noise3Texels); the others hold the function rounded to nearest.
enum class NoiseFormat { byteFloor, byteNearest, sixteenBits, half, single };
inline constexpr std::array kNoiseFormats{NoiseFormat::byteFloor, NoiseFormat::byteNearest,
                                          NoiseFormat::sixteenBits, NoiseFormat::half, NoiseFormat::single};
/// "8 bit, cut off" and so on.
std::string_view name(NoiseFormat format);
gpu::TexelFormat texelFormat(NoiseFormat format);

/// One value per octave.
using Octaves = std::array<double, noise::kOctaves>;

/// The function itself; the place is in periods.
Octaves exactNoise(const glm::dvec3& place);

/// n x n x n texels of the exact function as floats: x fastest, four octaves per texel.
std::vector<float> exactTexels(int n);

class NoiseVolume {
  public:
    /// `exact`: exactTexels(n), unused for byteFloor.
    NoiseVolume(int n, NoiseFormat format, const std::vector<float>& exact);

    /// Interpolates trilinearly in double; the texture repeats. Texel i stands for the place i / n.
    [[nodiscard]] Octaves at(const glm::dvec3& place) const;
    Result<gpu::Texture> upload(const gpu::Capabilities& capabilities) const;
    [[nodiscard]] int side() const { return n_; }
    [[nodiscard]] double bytes() const;

  private:
    int n_;
    NoiseFormat format_;
    std::vector<float> values_;  ///< as the format stores them
};

/// Point i of a sequence that fills the unit cube evenly (M. Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
glm::dvec3 spread(int i);

}  // namespace glibra::bench
