#pragma once
// How samples become one value per pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

namespace glibra::bench {

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

}  // namespace glibra::bench
