#pragma once
// What each pixel of a filtered picture shall be, in double.

#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "gpu/format/pixel_format.h"
#include "noise/noise.h"

namespace glibra::bench {

// How samples become one value per pixel.

/// How samples are weighted, by their distance from the centre of the pixel.
struct PixelFilter {
    std::string_view name;
    double radius;               ///< half the filter's width, in pixels
    double (*inside)(double x);  ///< the weight at 0 <= x <= radius along one axis, not normalised
    [[nodiscard]] double weight(double x) const {
        x = std::abs(x);
        return x > radius ? 0 : inside(x);
    }
};

inline double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-9 ? 1 : std::sin(angle) / angle;
}

inline double mitchell(double x) {
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16. / 3) / 6;
    return ((-7. / 3) * x * x * x + 12 * x * x - 20 * x + 32. / 3) / 6;
}

/// box: 1 pixel wide. tent: 2 pixels wide. Gaussian: exp(-2 x^2), cut off at 1.5. Mitchell: B = C = 1/3,
/// radius 2 (D. Mitchell and A. Netravali, Reconstruction Filters in Computer Graphics, 1988). Lanczos 2:
/// sinc windowed by sinc(x / 2), radius 2.
inline constexpr std::array<PixelFilter, 5> kPixelFilters{
    {{"box", .5, [](double) { return 1.; }},
     {"tent", 1, [](double x) { return 1 - x; }},
     {"Gaussian", 1.5, [](double x) { return std::exp(-2 * x * x); }},
     {"Mitchell", 2, mitchell},
     {"Lanczos 2", 2, [](double x) { return sinc(x) * sinc(x / 2); }}}};

/// The samples along one axis that contribute to one pixel.
struct Taps {
    std::size_t first = 0;
    std::vector<double> weights;
};

inline std::vector<Taps> tapsOf(int pixels, int factor, const PixelFilter& filter) {
    std::vector<Taps> all;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double centre = pixel + .5;
        const int first = std::max(0, static_cast<int>(std::floor((centre - filter.radius) * factor)));
        const int end =
            std::min(pixels * factor, static_cast<int>(std::ceil((centre + filter.radius) * factor)));
        Taps& taps = all.emplace_back(Taps{static_cast<std::size_t>(first), {}});
        double sum = 0;
        for (int i = first; i < end; ++i) {
            taps.weights.push_back(filter.weight((i + .5) / factor - centre));
            sum += taps.weights.back();
        }
        for (double& each : taps.weights) each /= sum;
    }
    return all;
}

/// width x height pixels of a grey picture with factor x factor samples per pixel on a regular grid. A weight
/// is the product of the weights along both axes; weights are scaled to add up to 1. Samples outside the
/// picture are left out.
inline std::vector<double> reduce(std::span<const float> samples, int width, int height, int factor,
                                  const PixelFilter& filter = kPixelFilters[0]) {
    const std::vector<Taps> across = tapsOf(width, factor, filter), down = tapsOf(height, factor, filter);
    const std::size_t columns = across.size(), sampleColumns = columns * static_cast<std::size_t>(factor);
    std::vector<double> narrow(samples.size() / sampleColumns * columns);
    for (std::size_t i = 0; i < narrow.size(); ++i) {
        const Taps& taps = across[i % columns];
        const float* from = samples.data() + i / columns * sampleColumns + taps.first;
        for (std::size_t k = 0; k < taps.weights.size(); ++k) narrow[i] += taps.weights[k] * from[k];
    }
    std::vector<double> pixels(down.size() * columns, 0.);
    for (std::size_t row = 0; row < down.size(); ++row)
        for (std::size_t i = 0; i < down[row].weights.size(); ++i)
            for (std::size_t column = 0; column < columns; ++column)
                pixels[row * columns + column] +=
                    down[row].weights[i] * narrow[(down[row].first + i) * columns + column];
    return pixels;
}

// Exact shares of pixels that triangles cover.

/// Corners in pixels; (0, 0) is the upper left corner of the picture.
using FlatTriangle = std::array<glm::dvec2, 3>;

using Polygon = std::vector<glm::dvec2>;

/// The part on one side of a line along an axis: coordinate >= border, or <= border if `isUpper`.
inline Polygon cut(const Polygon& polygon, int axis, double border, bool isUpper) {
    Polygon kept;
    const auto depth = [&](const glm::dvec2& point) {
        return isUpper ? border - point[axis] : point[axis] - border;
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double a = depth(from), b = depth(to);
        if (a >= 0) kept.push_back(from);
        if ((a > 0 && b < 0) || (a < 0 && b > 0)) kept.push_back(from + (to - from) * (a / (a - b)));
    }
    return kept;
}

inline double area(const Polygon& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

inline int limitedPixel(double value, int most) {
    return static_cast<int>(std::clamp(value, 0., static_cast<double>(most)));
}

/// The share of each pixel, 0..1, that the triangles cover. They do not overlap. Each triangle is clipped in
/// double by the square of the pixel (I. Sutherland and G. Hodgman, Reentrant Polygon Clipping, 1974). Rows
/// from the top.
inline std::vector<double> coverage(std::span<const FlatTriangle> triangles, int width, int height) {
    std::vector<double> shares(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.);
    for (const FlatTriangle& triangle : triangles) {
        const auto [left, right] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
        const auto [top, bottom] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
        const Polygon whole(triangle.begin(), triangle.end());
        for (int y = limitedPixel(top, height); y < limitedPixel(std::ceil(bottom), height); ++y) {
            const Polygon row = cut(cut(whole, 1, y, false), 1, y + 1, true);
            for (int x = limitedPixel(left, width); x < limitedPixel(std::ceil(right), width); ++x)
                shares[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)] += area(cut(cut(row, 0, x, false), 0, x + 1, true));
        }
    }
    return shares;
}

// A picture, its blur and its Sobel gradient in double.

/// One value per pixel, rows from bottom to top.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;
    /// The value of the nearest pixel inside the picture.
    [[nodiscard]] double at(int x, int y) const {
        const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};

template <class Value>
Plane filled(int width, int height, const Value& value) {
    Plane plane{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) plane.values.push_back(value(x, y));
    return plane;
}

/// 0..255, computed from the place (finaliser of MurmurHash3 by Austin Appleby).
inline std::uint32_t grain(int x, int y) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
    h = (h ^ (h >> 16)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13)) * 0xC2B2AE35U;
    return (h ^ (h >> 16)) & 255U;
}

inline int level(int x, int y, int side) {
    const int cell = side / 8;
    const int half = side / 2;
    if (x < half && y < half) return (x / cell + y / cell) % 2 == 0 ? 230 : 25;  // a board
    if (x >= half && y < half) return 255 * (x - half) / half;                   // a ramp
    if (x < half) return x % 5 == 0 || y % 7 == 0 ? 200 : 60;                    // thin lines
    return static_cast<int>(grain(x, y));
}

/// Edges, ramps, thin lines and grain. Each pixel is a multiple of 1/255 in 0..1.
inline Plane testPicture(int side) {
    return filled(side, side, [&](int x, int y) { return level(x, y, side) / 255.0; });
}

/// The weights of a Gaussian at 0..radius pixels, with standard deviation radius / 2. They add up to 1 over
/// -radius..radius. radius >= 1.
inline std::vector<double> gaussianWeights(int radius) {
    std::vector<double> weights;
    double sum = 0;
    for (int i = 0; i <= radius; ++i) {
        const double t = 2.0 * i / radius;
        weights.push_back(std::exp(-t * t / 2));
        sum += (i == 0 ? 1 : 2) * weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Each pixel becomes the weighted sum of the (2 radius + 1)^2 pixels around it. Pixels beyond the picture
/// equal those at its rim.
inline Plane blurred(const Plane& plane, const std::vector<double>& weights) {
    const int radius = static_cast<int>(weights.size()) - 1;
    return filled(plane.width, plane.height, [&](int x, int y) {
        double sum = 0;
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                sum += weights[static_cast<std::size_t>(std::abs(dx))] *
                       weights[static_cast<std::size_t>(std::abs(dy))] * plane.at(x + dx, y + dy);
        return sum;
    });
}

/// The length of the gradient by the 3 x 3 Sobel kernels, whose weights add up to 4 on either side: 0 to 4
/// sqrt(2) for values in 0..1.
inline Plane sobel(const Plane& plane) {
    return filled(plane.width, plane.height, [&](int x, int y) {
        double across = 0, up = 0;
        for (int i = -1; i <= 1; ++i) {
            const int weight = i == 0 ? 2 : 1;
            across += weight * (plane.at(x + 1, y + i) - plane.at(x - 1, y + i));
            up += weight * (plane.at(x + i, y + 1) - plane.at(x + i, y - 1));
        }
        return std::hypot(across, up);
    });
}

// A texture that is hard to minify, and its filtered values in double.

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

// Three-dimensional noise textures in several texel formats, interpolated in double, and their exact values.

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
