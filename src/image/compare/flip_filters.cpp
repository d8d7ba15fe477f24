#include "image/compare/flip_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "image/compare/lanes.h"

namespace glibra::image {
namespace {

constexpr double kPi = std::numbers::pi;

/// Values that are computed together: enough independent sums to keep the processor busy.
constexpr std::size_t kFilterChunk = 2 * kLanes;

/// Drops the ends of a filter that are too small to change a float result.
HalfFilter narrowed(const std::vector<double>& weights) {
    double largest = 0;
    for (const double each : weights) largest = std::max(largest, std::abs(each));
    std::size_t count = weights.size();
    while (count > 1 && std::abs(weights[count - 1]) < 1e-8 * largest) --count;
    HalfFilter result;
    for (std::size_t k = 0; k < count; ++k) result.push_back(static_cast<float>(weights[k]));
    return result;
}

/// The sum over both sides.
double sumOf(const std::vector<double>& half) {
    double sum = half[0];
    for (std::size_t k = 1; k < half.size(); ++k) sum += 2 * half[k];
    return sum;
}

/// exp(-pi^2 x^2 / b) at k pixels, x in degrees: the Gaussian of the contrast sensitivity in the space domain
/// (Andersson et al. 2020, equation 4).
std::vector<double> gaussian(double b, std::size_t radius, double pixelsPerDegree) {
    std::vector<double> half;
    for (std::size_t k = 0; k <= radius; ++k) {
        const double x = static_cast<double>(k) / pixelsPerDegree;
        half.push_back(std::exp(-kPi * kPi * x * x / b));
    }
    return half;
}

std::vector<double> scaled(std::vector<double> half, double factor) {
    for (double& each : half) each *= factor;
    return half;
}

/// Pads filters with zeros to equal lengths.
void widen(std::initializer_list<HalfFilter*> filters) {
    std::size_t count = 0;
    for (const HalfFilter* each : filters) count = std::max(count, each->size());
    for (HalfFilter* each : filters) each->resize(count);
}

template <std::size_t Even, std::size_t Odd>
void filterChunk(const float* in, std::ptrdiff_t step, std::size_t taps,
                 const std::array<FilterOutput, Even + Odd>& outputs, std::size_t at) {
    Lanes low[Even + Odd] = {}, high[Even + Odd] = {};
    const Lanes centerLow = loadLanes(in), centerHigh = loadLanes(in + kLanes);
    for (std::size_t o = 0; o < Even; ++o) {
        low[o] = outputs[o].weights[0] * centerLow;
        high[o] = outputs[o].weights[0] * centerHigh;
    }
    for (std::size_t k = 1; k < taps; ++k) {
        const float* after = in + static_cast<std::ptrdiff_t>(k) * step;
        const float* before = in - static_cast<std::ptrdiff_t>(k) * step;
        const Lanes afterLow = loadLanes(after), afterHigh = loadLanes(after + kLanes);
        const Lanes beforeLow = loadLanes(before), beforeHigh = loadLanes(before + kLanes);
        const Lanes sumLow = afterLow + beforeLow, sumHigh = afterHigh + beforeHigh;
        for (std::size_t o = 0; o < Even; ++o) {
            low[o] += outputs[o].weights[k] * sumLow;
            high[o] += outputs[o].weights[k] * sumHigh;
        }
        if constexpr (Odd > 0) {
            low[Even] += outputs[Even].weights[k] * (afterLow - beforeLow);
            high[Even] += outputs[Even].weights[k] * (afterHigh - beforeHigh);
        }
    }
    for (std::size_t o = 0; o < Even + Odd; ++o) {
        store(low[o], outputs[o].to + at);
        store(high[o], outputs[o].to + at + kLanes);
    }
}

template <std::size_t Even, std::size_t Odd>
void filter(const float* in, std::ptrdiff_t step, std::size_t count,
            const std::array<FilterOutput, Even + Odd>& outputs) {
    const std::size_t taps = outputs[0].weights.size();
    for (std::size_t x = 0; x < count; x += kFilterChunk)
        filterChunk<Even, Odd>(in + x, step, taps, outputs, x);
}

}  // namespace

FlipFilters::FlipFilters(double pixelsPerDegree) {
    // Table 1 of the paper: amplitude and width of each Gaussian.
    constexpr double kAchromatic = 0.0047, kRedGreen = 0.0053;
    constexpr double kBlueYellowA1 = 34.1, kBlueYellowB1 = 0.04, kBlueYellowA2 = 13.5, kBlueYellowB2 = 0.025;
    // Three standard deviations of the widest Gaussian.
    const auto contrastRadius =
        static_cast<std::size_t>(std::ceil(3 * std::sqrt(kBlueYellowB1 / (2 * kPi * kPi)) * pixelsPerDegree));
    const auto y = gaussian(kAchromatic, contrastRadius, pixelsPerDegree);
    const auto cx = gaussian(kRedGreen, contrastRadius, pixelsPerDegree);
    achromatic = narrowed(scaled(y, 1 / sumOf(y)));
    redGreen = narrowed(scaled(cx, 1 / sumOf(cx)));
    // The two-dimensional filter has the factor a sqrt(pi / b), so each direction has its root. The sum of
    // both products is 1.
    const auto part = [&](double a, double b) {
        return scaled(gaussian(b, contrastRadius, pixelsPerDegree), std::sqrt(a * std::sqrt(kPi / b)));
    };
    const auto first = part(kBlueYellowA1, kBlueYellowB1), second = part(kBlueYellowA2, kBlueYellowB2);
    const double total = std::hypot(sumOf(first), sumOf(second));
    blueYellow1 = narrowed(scaled(first, 1 / total));
    blueYellow2 = narrowed(scaled(second, 1 / total));
    widen({&blueYellow1, &blueYellow2});

    // Section 4.2: features are 0.082 degrees wide; the negative and the positive weights of a derivative sum
    // to -1 and 1.
    constexpr double kFeatureWidth = 0.082;
    const double deviation = kFeatureWidth / 2 * pixelsPerDegree;
    const auto featureRadius = static_cast<std::size_t>(std::ceil(3 * deviation));
    std::vector<double> g, dg, ddg;
    for (std::size_t k = 0; k <= featureRadius; ++k) {
        const double x = static_cast<double>(k) / deviation;
        g.push_back(std::exp(-x * x / 2));
        dg.push_back(-static_cast<double>(k) * g.back());
        ddg.push_back((x * x - 1) * g.back());
    }
    double oneSide = 0, positive = 0, negative = ddg[0];
    for (std::size_t k = 1; k <= featureRadius; ++k) {
        oneSide -= dg[k];
        (ddg[k] > 0 ? positive : negative) += 2 * ddg[k];
    }
    for (double& each : ddg) each /= each > 0 ? positive : -negative;
    gauss = narrowed(scaled(g, 1 / sumOf(g)));
    edge = narrowed(scaled(dg, 1 / oneSide));
    point = narrowed(ddg);
    widen({&gauss, &edge, &point, &achromatic});
    radius = std::max({gauss.size(), blueYellow1.size(), redGreen.size()}) - 1;
}

void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput out) {
    filter<1, 0>(in, step, count, {out});
}

void filterSymmetric(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                     FilterOutput second) {
    filter<2, 0>(in, step, count, {first, second});
}

void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput symmetric,
                FilterOutput antisymmetric) {
    filter<1, 1>(in, step, count, {symmetric, antisymmetric});
}

void filterBoth(const float* in, std::ptrdiff_t step, std::size_t count, FilterOutput first,
                FilterOutput second, FilterOutput third, FilterOutput antisymmetric) {
    filter<3, 1>(in, step, count, {first, second, third, antisymmetric});
}

}  // namespace glibra::image
