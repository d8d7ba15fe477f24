#pragma once
// Noise textures of three dimensions in several texel formats, and what they should hold.

#include <glibra/result.h>

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "gpu/capabilities.h"
#include "gpu/texture.h"
#include "noise/noise.h"

namespace glibra::bench {

/// byteFloor is what scenes get (noise::noise3Texels); the others are the function rounded to nearest.
enum class NoiseFormat { byteFloor, byteNearest, sixteenBits, half, single };
inline constexpr std::array kNoiseFormats{NoiseFormat::byteFloor, NoiseFormat::byteNearest,
                                          NoiseFormat::sixteenBits, NoiseFormat::half, NoiseFormat::single};
/// "8 bit, cut off" and so on.
std::string_view name(NoiseFormat format);
gpu::TexelFormat texelFormat(NoiseFormat format);

/// One value an octave.
using Octaves = std::array<double, noise::kOctaves>;

/// The function itself at a place in periods.
Octaves exactNoise(const glm::dvec3& place);

/// n x n x n texels of the function, exactly, as floats: x fastest, four octaves a texel.
std::vector<float> exactTexels(int n);

class NoiseVolume {
  public:
    /// `exact`: exactTexels(n), which is not looked at for byteFloor.
    NoiseVolume(int n, NoiseFormat format, const std::vector<float>& exact);

    /// Trilinear interpolation in double, repeating. Texel i stands for the place i / n.
    [[nodiscard]] Octaves at(const glm::dvec3& place) const;
    Result<gpu::Texture> upload(const gpu::Capabilities& capabilities) const;
    [[nodiscard]] int side() const { return n_; }
    [[nodiscard]] double bytes() const;

  private:
    int n_;
    NoiseFormat format_;
    std::vector<float> values_;  ///< as the format keeps them
};

/// Point i of a sequence that fills the unit cube evenly (M. Roberts, The Unreasonable Effectiveness of
/// Quasirandom Sequences, 2018).
glm::dvec3 spread(int i);

}  // namespace glibra::bench
