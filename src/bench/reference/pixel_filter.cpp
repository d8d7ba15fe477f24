#include "bench/reference/pixel_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace glibra::bench {
namespace {

struct FilterRow {
    std::string_view name;
    double radius;
};
/// In the order of PixelFilter.
constexpr std::array<FilterRow, 5> kFilterRows{
    {{"box", .5}, {"tent", 1}, {"Gaussian", 1.5}, {"Mitchell", 2}, {"Lanczos 2", 2}}};

const FilterRow& filterRow(PixelFilter filter) {
    return kFilterRows.at(static_cast<std::size_t>(filter));
}

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return std::abs(angle) < 1e-9 ? 1 : std::sin(angle) / angle;
}

double mitchell(double x) {
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16. / 3) / 6;
    return ((-7. / 3) * x * x * x + 12 * x * x - 20 * x + 32. / 3) / 6;
}

/// The samples along one axis that contribute to one pixel.
struct Taps {
    std::size_t first = 0;
    std::vector<double> weights;
};

std::vector<Taps> tapsOf(int pixels, int factor, PixelFilter filter) {
    const double radius = radiusOf(filter);
    std::vector<Taps> all;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double centre = pixel + .5;
        const int first = std::max(0, static_cast<int>(std::floor((centre - radius) * factor)));
        const int end = std::min(pixels * factor, static_cast<int>(std::ceil((centre + radius) * factor)));
        Taps taps{.first = static_cast<std::size_t>(first), .weights = {}};
        double sum = 0;
        for (int i = first; i < end; ++i) {
            taps.weights.push_back(weightOf(filter, (i + .5) / factor - centre));
            sum += taps.weights.back();
        }
        for (double& each : taps.weights) each /= sum;
        all.push_back(std::move(taps));
    }
    return all;
}

}  // namespace

std::string_view name(PixelFilter filter) {
    return filterRow(filter).name;
}

double radiusOf(PixelFilter filter) {
    return filterRow(filter).radius;
}

double weightOf(PixelFilter filter, double x) {
    x = std::abs(x);
    if (x > radiusOf(filter)) return 0;
    switch (filter) {
        case PixelFilter::tent:
            return 1 - x;
        case PixelFilter::gaussian:
            return std::exp(-2 * x * x);
        case PixelFilter::mitchell:
            return mitchell(x);
        case PixelFilter::lanczos2:
            return sinc(x) * sinc(x / 2);
        case PixelFilter::box:
            break;
    }
    return 1;
}

std::vector<double> reduce(std::span<const float> samples, int width, int height, int factor,
                           PixelFilter filter) {
    const std::vector<Taps> across = tapsOf(width, factor, filter);
    const std::vector<Taps> down = tapsOf(height, factor, filter);
    const auto columns = static_cast<std::size_t>(width);
    const std::size_t sampleColumns = columns * static_cast<std::size_t>(factor);
    const std::size_t sampleRows = static_cast<std::size_t>(height) * static_cast<std::size_t>(factor);
    std::vector<double> narrow(sampleRows * columns);
    for (std::size_t row = 0; row < sampleRows; ++row)
        for (std::size_t column = 0; column < columns; ++column) {
            const Taps& taps = across[column];
            const float* from = samples.data() + row * sampleColumns + taps.first;
            double sum = 0;
            for (std::size_t i = 0; i < taps.weights.size(); ++i) sum += taps.weights[i] * from[i];
            narrow[row * columns + column] = sum;
        }
    std::vector<double> pixels(static_cast<std::size_t>(height) * columns, 0.);
    for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row)
        for (std::size_t i = 0; i < down[row].weights.size(); ++i)
            for (std::size_t column = 0; column < columns; ++column)
                pixels[row * columns + column] +=
                    down[row].weights[i] * narrow[(down[row].first + i) * columns + column];
    return pixels;
}

double errorInBytes(const std::vector<double>& picture, const std::vector<double>& reference) {
    double sum = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
        sum += (picture[i] - reference[i]) * (picture[i] - reference[i]);
    return 255 * std::sqrt(sum / static_cast<double>(picture.size()));
}

}  // namespace glibra::bench
