#include "image/compare/structure.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "image/compare/alike.h"
#include "image/compare/lanes.h"
#include "image/convert.h"

namespace glibra::image {
namespace {

constexpr int kWindow = 4, kWindowStep = 2;
constexpr int kBlockWindows = 16, kBlockStep = 8;  // in windows: 32 and 16 pixels

/// Replaces NaN: against a number it moves the mean of a window so far that the loss is 1.
constexpr float kNan = -16.F * kWindow * kWindow;

/// RGBA in 0..255, one pixel per vector. Rows and columns are extended by one pixel on either side, so that
/// windows can move.
class Plane {
  public:
    explicit Plane(const Image& image) : stride_(static_cast<std::size_t>(image.width) + 2) {
        const Image pixels = withType(withComponents(image, 4), Component::f32);
        values_.resize(stride_ * (static_cast<std::size_t>(image.height) + 2) * kLanes);
        for (int y = -1; y <= image.height; ++y)
            for (int x = -1; x <= image.width; ++x) {
                const auto row = pixels.row(std::clamp(y, 0, image.height - 1));
                const auto column = static_cast<std::size_t>(std::clamp(x, 0, image.width - 1));
                float* pixel = values_.data() + at(x, y);
                std::memcpy(pixel, row.data() + column * sizeof(Lanes), sizeof(Lanes));
                for (std::size_t c = 0; c < kLanes; ++c)
                    pixel[c] = std::isnan(pixel[c]) ? kNan : std::clamp(pixel[c], 0.F, 1.F) * 255;
            }
    }

    [[nodiscard]] Lanes pixel(int x, int y) const { return loadLanes(values_.data() + at(x, y)); }
    [[nodiscard]] const float* row(int x, int y) const { return values_.data() + at(x, y); }

  private:
    [[nodiscard]] std::size_t at(int x, int y) const {
        return (static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1)) * kLanes;
    }

    std::size_t stride_;
    std::vector<float> values_;
};

struct Window {
    int x, y, width, height;
};

bool sameInWindow(const Plane& a, const Plane& b, const Window& w) {
    const std::size_t bytes = static_cast<std::size_t>(w.width) * sizeof(Lanes);
    for (int y = w.y; y < w.y + w.height; ++y)
        if (std::memcmp(a.row(w.x, y), b.row(w.x, y), bytes) != 0) return false;
    return true;
}

/// The loss of the window with the window of the second picture moved by (dx, dy).
float lossAt(const Plane& a, const Plane& b, const Window& w, int dx, int dy) {
    constexpr float kContrast = 0.03F * 255 * 0.03F * 255, kBrightness = 16;
    Lanes sumA{}, sumB{}, squaresA{}, squaresB{}, products{};
    for (int y = w.y; y < w.y + w.height; ++y)
        for (int x = w.x; x < w.x + w.width; ++x) {
            const Lanes p = a.pixel(x, y), q = b.pixel(x + dx, y + dy);
            sumA += p;
            sumB += q;
            squaresA += p * p;
            squaresB += q * q;
            products += p * q;
        }
    const float share = 1.F / static_cast<float>(w.width * w.height);
    const Lanes meanA = sumA * share, meanB = sumB * share;
    const Lanes varianceA = squaresA * share - meanA * meanA, varianceB = squaresB * share - meanB * meanB;
    const Lanes covariance = products * share - meanA * meanB;
    const Lanes shape = 1 - (2 * covariance + kContrast) / (varianceA + varianceB + kContrast);
    const Lanes brightness = (meanA - meanB) * (1 / kBrightness);
    const Lanes loss = larger(shape, brightness * brightness);
    return std::clamp(std::max({loss[0], loss[1], loss[2], loss[3]}), 0.F, 1.F);
}

float lossOf(const Plane& a, const Plane& b, const Window& window) {
    if (sameInWindow(a, b, window)) return 0;
    float best = lossAt(a, b, window, 0, 0);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (dx != 0 || dy != 0) best = std::min(best, lossAt(a, b, window, dx, dy));
    return best;
}

/// The starts of windows along a side: every 4 pixels, the last one at the end.
std::vector<int> windowStarts(int side) {
    std::vector<int> starts;
    for (int at = 0; at + kWindow < side; at += kWindowStep) starts.push_back(at);
    starts.push_back(std::max(side - kWindow, 0));
    return starts;
}

/// The starts of blocks along a side with this many windows.
std::vector<std::size_t> blockStarts(std::size_t windows) {
    std::vector<std::size_t> starts{0};
    while (starts.back() + kBlockWindows < windows) starts.push_back(starts.back() + kBlockStep);
    return starts;
}

StructureResult structureOfAlike(const Image& expected, const Image& got) {
    const Plane a(expected), b(got);
    const std::vector<int> columns = windowStarts(expected.width), rows = windowStarts(expected.height);
    std::vector<double> losses;
    losses.reserve(columns.size() * rows.size());
    for (const int y : rows)
        for (const int x : columns) {
            const Window window{x, y, std::min(kWindow, expected.width), std::min(kWindow, expected.height)};
            losses.push_back(static_cast<double>(lossOf(a, b, window)));
        }
    StructureResult worst;
    worst.difference = -1;
    for (const std::size_t top : blockStarts(rows.size()))
        for (const std::size_t left : blockStarts(columns.size())) {
            const std::size_t bottom = std::min(top + kBlockWindows, rows.size());
            const std::size_t right = std::min(left + kBlockWindows, columns.size());
            double sum = 0;
            for (std::size_t y = top; y < bottom; ++y)
                for (std::size_t x = left; x < right; ++x) sum += losses[y * columns.size() + x];
            const double mean = sum / static_cast<double>((bottom - top) * (right - left));
            if (mean <= worst.difference) continue;
            worst = {mean, columns[left], rows[top], columns[right - 1] + kWindow - columns[left],
                     rows[bottom - 1] + kWindow - rows[top]};
        }
    worst.width = std::min(worst.width, expected.width);
    worst.height = std::min(worst.height, expected.height);
    return worst;
}

}  // namespace

StructureResult structure(const Image& expected, const Image& got) {
    if (!areComparable(expected, got)) return {1, 0, 0, 0, 0};
    return withAlike(expected, got, structureOfAlike);
}

}  // namespace glibra::image
