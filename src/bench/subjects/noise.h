#pragma once
// Three-dimensional noise textures in several texel formats, their exact values, and noise on the device.

#include <array>
#include <glm/vec3.hpp>

#include "bench/core/device.h"
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
Octaves exactNoise(const glm::dvec3& place);
/// n x n x n texels of the exact function as floats: x fastest, four octaves per texel.
std::vector<float> exactTexels(int n);

class NoiseVolume {
  public:
    /// `exact`: exactTexels(n), unused for a format that is cut off.
    NoiseVolume(int n, const NoiseFormat& format, const std::vector<float>& exact);
    /// Interpolates trilinearly in double; the texture repeats. Texel i stands for the place i / n.
    [[nodiscard]] Octaves at(const glm::dvec3& place) const;
    [[nodiscard]] Texels upload(Bench& bench) const;
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

/// From a texture filtered by the driver, from one filtered by the shader, and from the function itself.
enum class NoiseShader { driverFilter, shaderFilter, function };

/// A picture of the plane `corner` + x `across` + y `up` through the noise, with x and y from 0 to 1. Places
/// are in periods.
struct NoisePlane {
    glm::dvec3 corner{0}, across{1, 0, 0}, up{0, 1, 0};
};

class NoisePicture {
  public:
    NoisePicture(Bench& bench, NoiseShader shader, int side);
    /// Draws and waits. The first two shaders sample the texture; `function` needs none.
    void draw(const NoisePlane& plane, const Texels* texture) const;
    /// The octaves of every pixel of the last draw, rows from the top.
    [[nodiscard]] std::vector<float> pixels() const { return canvas_.pixels(); }
    /// The place in the noise that a pixel shows.
    [[nodiscard]] glm::dvec3 place(const NoisePlane& plane, int column, int row) const;
    [[nodiscard]] int side() const { return canvas_.width(); }

  private:
    Canvas canvas_;
    Shader shader_;
};

std::vector<Figure> measureNoise(Bench& bench);

}  // namespace glibra::bench
