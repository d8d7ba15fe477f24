#pragma once
// A texture that is hard to minify, with mipmaps, and what its texels give in double.

#include <glad/gl.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "gpu/name.h"
#include "gpu/texture.h"

namespace glibra::bench {

inline constexpr int kCardSide = 512;  ///< texels

/// Grey bytes, t = 0 first: squares of 8 texels, every other one with diagonal stripes of 3 texels, darkest
/// in the middle of s.
std::vector<std::uint8_t> testCard();

/// The next smaller mipmap level: means of 2 x 2 bytes, rounded.
std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& texels, int side);

/// Bilinear interpolation in double of a square of bytes, repeating; `place` in texels, texel i has its
/// centre at i + 1/2. 0..1.
double bilinear(const std::vector<std::uint8_t>& texels, int side, const glm::dvec2& place);

/// The test card as RGBA8 with all its levels.
class CardTexture {
  public:
    static Result<CardTexture> create();
    void bind(int unit) const;
    /// Replaces the smaller levels by the driver's own (glGenerateMipmap) and gives the largest difference of
    /// a texel from `halved`, in 255ths.
    [[nodiscard]] double differenceOfDriversLevels() const;

  private:
    gpu::Name<gpu::deleteTexture> name_;
};

}  // namespace glibra::bench
