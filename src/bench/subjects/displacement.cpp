#include "bench/subjects/displacement.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glibra::bench {
namespace {

/// The smallest and largest values around each component of a picture.
struct Ranges {
    std::vector<std::uint8_t> low, high;
};

Ranges rangesOf(const image::Image& picture) {
    Ranges ranges;
    for (const std::byte each : picture.data) ranges.low.push_back(std::to_integer<std::uint8_t>(each));
    ranges.high = ranges.low;
    return ranges;
}

/// Minima and maxima over every value and those `step` components before and after it, within runs of `run`
/// components.
void spreadExtremes(std::vector<std::uint8_t>& values, std::size_t step, std::size_t run, bool wantsLargest) {
    const std::vector<std::uint8_t> before = values;
    const auto pick = [&](std::uint8_t a, std::uint8_t b) {
        return wantsLargest ? std::max(a, b) : std::min(a, b);
    };
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t inRun = i % run;
        if (inRun >= step) values[i] = pick(values[i], before[i - step]);
        if (inRun + step < run) values[i] = pick(values[i], before[i + step]);
    }
}

/// Extends the neighbourhood by one pixel in every direction.
void grow(Ranges& ranges, const image::Image& picture) {
    const auto pixel = static_cast<std::size_t>(picture.components);
    const std::size_t row = pixel * static_cast<std::size_t>(picture.width);
    for (const bool wantsLargest : {false, true}) {
        std::vector<std::uint8_t>& values = wantsLargest ? ranges.high : ranges.low;
        spreadExtremes(values, pixel, row, wantsLargest);
        spreadExtremes(values, row, values.size(), wantsLargest);
    }
}

/// The number of pixels with values outside the ranges.
std::size_t outside(const image::Image& picture, const Ranges& ranges) {
    constexpr int kTolerance = 8;
    const auto components = static_cast<std::size_t>(picture.components);
    std::size_t pixels = 0;
    for (std::size_t first = 0; first < picture.data.size(); first += components) {
        bool isOutside = false;
        for (std::size_t i = first; i < first + components; ++i) {
            const int value = std::to_integer<int>(picture.data[i]);
            isOutside =
                isOutside || value < ranges.low[i] - kTolerance || value > ranges.high[i] + kTolerance;
        }
        pixels += isOutside ? 1 : 0;
    }
    return pixels;
}

}  // namespace

int displacement(const image::Image& a, const image::Image& b, int most) {
    const std::size_t allowed = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height) / 1000;
    Ranges aroundA = rangesOf(a), aroundB = rangesOf(b);
    for (int radius = 0; radius <= most; ++radius) {
        if (outside(a, aroundB) <= allowed && outside(b, aroundA) <= allowed) return radius;
        grow(aroundA, a);
        grow(aroundB, b);
    }
    return most + 1;
}

}  // namespace glibra::bench
