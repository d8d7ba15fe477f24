#include "image/compare/compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

#include "image/bytes.h"
#include "image/compare/alike.h"

namespace glibra::image {
namespace {

/// The number of values of a row that can be summed before the sum of their squares could overflow.
constexpr std::size_t kSumChunk = 4096;

/// Steps between two values; integers for integer types, so that sums of squares are exact.
template <class Value>
auto distance(Value a, Value b) {
    if constexpr (std::is_same_v<Value, std::uint8_t>) {
        return static_cast<std::uint32_t>(a > b ? a - b : b - a);
    } else if constexpr (std::is_integral_v<Value>) {
        return static_cast<std::uint64_t>(a > b ? a - b : b - a);
    } else {
        return apart(a, b);
    }
}

/// Largest distance and sum of squares of `count` values; the compiler vectorises the loops.
template <class Value, class Distance>
void addDistances(const std::byte* a, const std::byte* b, std::size_t count, Distance& largest,
                  Distance& squares) {
    for (std::size_t i = 0; i < count; ++i) {
        const Distance d = distance(valueAt<Value>(a, i), valueAt<Value>(b, i));
        largest = d > largest ? d : largest;
        squares += d * d;
    }
}

std::uint64_t countDiffering4(const std::byte* a, const std::byte* b, std::size_t pixels) {
    std::uint32_t count = 0;  // a row has fewer pixels
    for (std::size_t i = 0; i < pixels; ++i)
        count += valueAt<std::uint32_t>(a, i) != valueAt<std::uint32_t>(b, i) ? 1U : 0U;
    return count;
}

template <class Value>
std::uint64_t countDiffering(const std::byte* a, const std::byte* b, std::size_t pixels,
                             std::size_t components) {
    if constexpr (sizeof(Value) == 1)
        if (components == 4) return countDiffering4(a, b, pixels);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        bool differs = false;
        for (std::size_t c = 0; c < components; ++c)
            differs |=
                distance(valueAt<Value>(a, i * components + c), valueAt<Value>(b, i * components + c)) != 0;
        count += differs ? 1U : 0U;
    }
    return count;
}

/// True if no pixel of either has another alpha than 1.
template <class Value>
bool isOpaqueAlike(const Image& a, const Image& b, std::size_t pixels) {
    const auto components = static_cast<std::size_t>(a.components);
    constexpr Value kOne = std::is_integral_v<Value> ? std::numeric_limits<Value>::max() : Value{1};
    for (std::size_t i = components - 1; i < pixels * components; i += components)
        if (valueAt<Value>(a.data.data(), i) != kOne || valueAt<Value>(b.data.data(), i) != kOne)
            return false;
    return true;
}

template <class Value>
Comparison compareAlike(const Image& a, const Image& b) {
    using Distance = decltype(distance(Value{}, Value{}));
    using Sum = std::conditional_t<std::is_integral_v<Value>, std::uint64_t, double>;
    Comparison result;
    const auto components = static_cast<std::size_t>(a.components);
    const std::size_t rowValues = a.rowBytes() / sizeof(Value);
    Distance largest = 0;
    Sum squares = 0;
    for (int y = 0; y < a.height; ++y) {
        const std::byte* rowA = a.row(y).data();
        const std::byte* rowB = b.row(y).data();
        if (std::memcmp(rowA, rowB, a.rowBytes()) == 0) continue;
        Distance ofRow = 0;
        for (std::size_t at = 0; at < rowValues; at += kSumChunk) {
            Distance ofChunk = 0;
            addDistances<Value>(rowA + at * sizeof(Value), rowB + at * sizeof(Value),
                                std::min(kSumChunk, rowValues - at), ofRow, ofChunk);
            squares += ofChunk;
        }
        if (ofRow == 0) continue;
        result.differingPixels +=
            countDiffering<Value>(rowA, rowB, static_cast<std::size_t>(a.width), components);
        if (ofRow <= largest) continue;
        largest = ofRow;
        std::size_t place = 0;
        while (distance(valueAt<Value>(rowA, place), valueAt<Value>(rowB, place)) != largest) ++place;
        result.x = static_cast<int>(place / components);
        result.y = y;
        result.component = static_cast<int>(place % components);
    }
    const double full =
        std::is_integral_v<Value> ? static_cast<double>(std::numeric_limits<Value>::max()) : 1;
    // An alpha that the pictures need not have does not make their difference less.
    const std::size_t pixels = a.data.size() / (sizeof(Value) * components);
    const bool isOpaque = squares > 0 && components % 2 == 0 && isOpaqueAlike<Value>(a, b, pixels);
    const double count = static_cast<double>(pixels * (components - (isOpaque ? 1 : 0)));
    result.largest = static_cast<double>(largest) / full;
    result.rootMeanSquare = std::sqrt(static_cast<double>(squares) / count) / full;
    result.identical = result.differingPixels == 0;
    return result;
}

std::uint64_t countNonFiniteOfBoth(const Image& a, const Image& b) {
    if (a.type != Component::f32) return 0;
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.data.size() / sizeof(float); ++i)
        if (!std::isfinite(valueAt<float>(a.data.data(), i)) ||
            !std::isfinite(valueAt<float>(b.data.data(), i)))
            ++count;
    return count;
}

}  // namespace

Comparison compare(const Image& first, const Image& second) {
    Comparison result;
    if (!areComparable(first, second)) {
        result.sameSize = first.width == second.width && first.height == second.height;
        result.identical = result.sameSize && first.data == second.data;
        return result;
    }
    return withAlike(first, second, [](const Image& a, const Image& b) {
        Comparison found = withZeroOf(a.type, [&](auto zero) { return compareAlike<decltype(zero)>(a, b); });
        found.nonFinite = countNonFiniteOfBoth(a, b);
        return found;
    });
}

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

namespace {

// Coefficients of 1, t, ..., t^6 for red, green, blue.
constexpr double kMagma[7][3] = {
    {-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
    {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
    {8.353717279216625, -3.577719514958484, 0.3144679030132573},
    {-27.66873308576866, 14.26473078096533, -13.64921318813922},
    {52.17613981234068, -27.94360607168351, 12.94416944238394},
    {-50.76852536473588, 29.04658282127291, 4.23415299384598},
    {18.65570506591883, -11.48977351997711, -5.601961508734096},
};

using HeatColor = std::array<std::byte, 3>;

/// 256 colours, so that a pixel costs one look-up.
const std::array<HeatColor, 256>& heatColors() {
    static const std::array<HeatColor, 256> colors = [] {
        std::array<HeatColor, 256> all{};
        for (std::size_t i = 0; i < all.size(); ++i) {
            double rgb[3];
            magma(static_cast<double>(i) / 255, rgb[0], rgb[1], rgb[2]);
            for (std::size_t c = 0; c < 3; ++c) all[i][c] = static_cast<std::byte>(std::lround(rgb[c] * 255));
        }
        all[0] = {};  // black means no difference, and only that
        return all;
    }();
    return colors;
}

Image emptyMap(int width, int height) {
    Image map{width, height, 3, Component::u8, {}};
    map.data.resize(map.rowBytes() * static_cast<std::size_t>(height));
    return map;
}

/// `value` is in 0..1; values above 0 are never black.
void paint(Image& map, std::size_t pixel, double value) {
    const auto index = value > 0 ? std::max<long>(1, std::lround(std::min(value, 1.) * 255)) : 0;
    std::memcpy(map.data.data() + 3 * pixel, heatColors()[static_cast<std::size_t>(index)].data(), 3);
}

}  // namespace

void magma(double value, double& red, double& green, double& blue) {
    const double t = value < 1 ? std::max(value, 0.) : 1;  // 1 for NaN
    const auto polynomial = [t](std::size_t c) {
        double sum = 0;
        for (std::size_t i = std::size(kMagma); i-- > 0;) sum = sum * t + kMagma[i][c];
        return std::clamp(sum, 0., 1.);
    };
    red = polynomial(0);
    green = polynomial(1);
    blue = polynomial(2);
}

Image differenceHeatMap(const Image& expected, const Image& got) {
    if (!areComparable(expected, got)) return {};
    return withAlike(expected, got, [](const Image& first, const Image& second) {
        const Image a = withType(first, Component::f32), b = withType(second, Component::f32);
        Image map = emptyMap(a.width, a.height);
        const auto components = static_cast<std::size_t>(a.components);
        for (std::size_t pixel = 0; pixel < map.data.size() / 3; ++pixel) {
            double largest = 0;
            for (std::size_t i = pixel * components; i < (pixel + 1) * components; ++i)
                largest = std::max(largest,
                                   apart(valueAt<float>(a.data.data(), i), valueAt<float>(b.data.data(), i)));
            paint(map, pixel, std::log2(1 + 255 * largest) / 8);
        }
        return map;
    });
}

Image flipHeatMap(const FlipResult& result) {
    Image map = emptyMap(result.width, result.height);
    for (std::size_t i = 0; i < result.errors.size(); ++i)
        paint(map, i, static_cast<double>(result.errors[i]));
    return map;
}

}  // namespace glibra::image
