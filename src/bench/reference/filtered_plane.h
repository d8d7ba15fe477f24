#pragma once
// A picture, its blur and its Sobel gradient in double.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace glibra::bench {

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

}  // namespace glibra::bench
