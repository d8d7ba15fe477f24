#pragma once
// A texture that is hard to minify, and its filtered values in double.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <glm/vec2.hpp>
#include <vector>

namespace glibra::bench {

using Bytes = std::vector<std::uint8_t>;

inline constexpr int kCardSide = 512;  ///< texels

/// Grey bytes, t = 0 first: squares of 8 texels, every other one with diagonal stripes of 3 texels, darkest
/// in the middle of s.
inline Bytes testCard() {
    constexpr int kSquare = 8, kStripe = 3;
    Bytes texels;
    for (int t = 0; t < kCardSide; ++t)
        for (int s = 0; s < kCardSide; ++s) {
            const bool isStriped = (s / kSquare + t / kSquare) % 2 == 0;
            const bool isLight = isStriped ? (s + t) / kStripe % 2 == 0 : s / (2 * kSquare) % 2 == 0;
            texels.push_back(
                static_cast<std::uint8_t>(isLight ? 160 + 95 * std::abs(2 * s - kCardSide) / kCardSide : 20));
        }
    return texels;
}

/// The next smaller mipmap level: rounded means of 2 x 2 bytes.
inline Bytes halved(const Bytes& texels, int side) {
    const auto columns = static_cast<std::size_t>(side);
    Bytes smaller;
    for (std::size_t t = 0; t < columns; t += 2)
        for (std::size_t s = 0; s < columns; s += 2) {
            const std::size_t first = t * columns + s;
            const int sum =
                texels[first] + texels[first + 1] + texels[first + columns] + texels[first + columns + 1];
            smaller.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
        }
    return smaller;
}

/// Interpolates a repeating square of bytes bilinearly in double. `place` is in texels; the centre of texel i
/// is at i + 1/2. The result is in 0..1.
inline double bilinear(const Bytes& texels, int side, const glm::dvec2& place) {
    const double s = place.x - .5, t = place.y - .5;
    const double left = std::floor(s), low = std::floor(t);
    const auto at = [&](double column, double row) {
        const auto wrapped = [side](double index) {
            return static_cast<std::size_t>(index - std::floor(index / side) * side);
        };
        return static_cast<double>(texels[wrapped(row) * static_cast<std::size_t>(side) + wrapped(column)]);
    };
    const double x = s - left, y = t - low;
    return std::lerp(std::lerp(at(left, low), at(left + 1, low), x),
                     std::lerp(at(left, low + 1), at(left + 1, low + 1), x), y) /
           255;
}

}  // namespace glibra::bench
