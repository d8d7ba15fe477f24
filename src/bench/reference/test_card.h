#pragma once
// A texture that is hard to minify, with mipmaps, and its filtered values in double.

#include <glad/gl.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gpu/object/name.h"
#include "gpu/object/texture.h"

namespace glibra::bench {

inline constexpr int kCardSide = 512;  ///< texels

/// Grey bytes, t = 0 first: squares of 8 texels, every other one with diagonal stripes of 3 texels, darkest
/// in the middle of s.
std::vector<std::uint8_t> testCard();

/// The next smaller mipmap level: rounded means of 2 x 2 bytes.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& texels, int side);

/// Interpolates a repeating square of bytes bilinearly in double. `place` is in texels; the centre of texel i
/// is at i + 1/2. The result is in 0..1.
double bilinear(const std::vector<std::uint8_t>& texels, int side, const glm::dvec2& place);

/// The test card as an RGBA8 texture with all mipmap levels.
class CardTexture {
  public:
    static Result<CardTexture> create();
    void bind(int unit) const;
    /// Replaces the smaller levels by the driver's (glGenerateMipmap) and returns the largest difference of a
    /// texel from `halved`, in 255ths.
    [[nodiscard]] double differenceOfDriversLevels() const;

  private:
    gpu::Name<glDeleteTextures> name_;
};

}  // namespace glibra::bench
