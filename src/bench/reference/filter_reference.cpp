#include "bench/reference/filter_reference.h"

#include <algorithm>
#include <cmath>

namespace glibra::bench {
namespace {

/// 0..255, computed from the place (finaliser of MurmurHash3 by Austin Appleby).
std::uint32_t grain(int x, int y) {
    std::uint32_t h =
        static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U;
    h = (h ^ (h >> 16)) * 0x85EBCA6BU;
    h = (h ^ (h >> 13)) * 0xC2B2AE35U;
    return (h ^ (h >> 16)) & 255U;
}

int level(int x, int y, int side) {
    const int cell = side / 8;
    const int half = side / 2;
    if (x < half && y < half) return (x / cell + y / cell) % 2 == 0 ? 230 : 25;  // a board
    if (x >= half && y < half) return 255 * (x - half) / half;                   // a ramp
    if (x < half) return x % 5 == 0 || y % 7 == 0 ? 200 : 60;                    // thin lines
    return static_cast<int>(grain(x, y));
}

template <class Value>
Plane filled(int width, int height, const Value& value) {
    Plane plane{width, height, {}};
    plane.values.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) plane.values.push_back(value(x, y));
    return plane;
}

}  // namespace

double Plane::at(int x, int y) const {
    const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
}

Plane testPicture(int side) {
    return filled(side, side, [&](int x, int y) { return level(x, y, side) / 255.0; });
}

std::vector<std::uint8_t> bytesOf(const Plane& plane) {
    std::vector<std::uint8_t> bytes;
    for (const double value : plane.values)
        bytes.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
    return bytes;
}

std::vector<double> gaussianWeights(int radius) {
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

Plane blurred(const Plane& plane, const std::vector<double>& weights) {
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

Plane sobel(const Plane& plane) {
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

double rootMeanSquare(const Plane& a, const Plane& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double difference = a.values[i] - b.values[i];
        sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(a.values.size()));
}

}  // namespace glibra::bench
