#pragma once
// A texture that is hard to minify, and its filtered values in double.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "bench/core/bench.h"

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

std::vector<Figure> measureMinification(Bench& bench);

}  // namespace glibra::bench
