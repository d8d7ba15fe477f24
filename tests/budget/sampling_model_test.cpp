// The models of samples and noise compared with measurements.

#include "budget/error_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "noise/noise.h"

namespace glibra::budget {
namespace {

TEST(SamplingModel, TakesTheFewestSamplesThatKeepTheBound) {
    EXPECT_EQ(leastSamples(.5, 16), 1);
    EXPECT_EQ(leastSamples(.49, 16), 2);
    EXPECT_EQ(leastSamples(.25, 16), 4);
    EXPECT_EQ(leastSamples(.126, 16), 16);
    EXPECT_EQ(leastSamples(.01, 16), 16);
    EXPECT_EQ(leastSamples(.25, 1), 1);
}

/// For a row of n samples at equal distances, returns the error at the worst place of an edge across it.
TEST(SamplingModel, IsHalfTheDistanceOfTheRowsOfARegularPattern) {
    for (const int rows : {1, 2, 4, 8}) {
        double worst = 0;
        for (double edge = 0; edge <= 1; edge += 1e-4) {
            int covered = 0;
            for (int i = 0; i < rows; ++i) covered += (i + .5) / rows < edge ? 1 : 0;
            worst = std::max(worst, std::abs(static_cast<double>(covered) / rows - edge));
        }
        EXPECT_NEAR(edgeError(rows * rows), worst, 2e-4) << rows;
    }
}

double exact(const std::vector<double>& place) {
    double sum = 0;
    for (int octave = 0; octave < noise::kOctaves; ++octave) {
        const double n = noise::cellsOf(octave);
        sum += place.size() == 3 ? noise::noise3(place[0] * n, place[1] * n, place[2] * n, octave)
                                 : noise::noise2(place[0] * n, place[1] * n, octave);
    }
    return sum;
}

/// The result of a linear filter on texels of 255 or 65535 steps, plus the half byte by which cutting to
/// bytes lowers the values on average.
template <class Texels>
double filtered(const Texels& texels, int size, const std::vector<double>& place) {
    constexpr double kSteps = std::numeric_limits<typename Texels::value_type>::max();
    double sum = 0;
    const auto n = static_cast<std::size_t>(size);
    for (unsigned corner = 0; corner < 1U << place.size(); ++corner) {
        double weight = 1;
        std::size_t at = 0, stride = 1;
        for (std::size_t axis = 0; axis < place.size(); ++axis) {
            const double scaled = place[axis] * size, cell = std::floor(scaled);
            const bool isFar = (corner >> axis & 1U) != 0;
            weight *= isFar ? scaled - cell : 1 - scaled + cell;
            at += stride * ((static_cast<std::size_t>(cell) + (isFar ? 1 : 0)) % n);
            stride *= n;
        }
        for (std::size_t octave = 0; octave < 4; ++octave)
            sum += weight * (texels[4 * at + octave] / kSteps + .5 / 255);
    }
    return sum;
}

using Place = std::vector<double>;

class NoiseError : public testing::TestWithParam<std::size_t> {
  protected:
    static constexpr int kPlaces = 40000;

    [[nodiscard]] int dimensions() const { return static_cast<int>(GetParam()); }
    Place anywhere() {
        Place place(GetParam());
        for (double& each : place) each = uniform_(random_);
        return place;
    }
    /// Length of the sum's gradient.
    static double gradient(const Place& place) {
        double squares = 0;
        for (std::size_t axis = 0; axis < place.size(); ++axis) {
            constexpr double kStep = 1e-5;
            Place low = place, high = place;
            low[axis] -= kStep;
            high[axis] += kStep;
            squares += std::pow((exact(high) - exact(low)) / (2 * kStep), 2);
        }
        return std::sqrt(squares);
    }
    [[nodiscard]] noise::TexelShorts shorts(int size) const {
        return dimensions() == 3 ? noise::noise3Shorts(size) : noise::noise2Shorts(size);
    }
    [[nodiscard]] noise::TexelBytes bytes(int size) const {
        return dimensions() == 3 ? noise::noise3Texels(size) : noise::noise2Texels(size);
    }

  private:
    std::mt19937 random_{3};
    std::uniform_real_distribution<double> uniform_{0, 1};
};

INSTANTIATE_TEST_SUITE_P(Dimensions, NoiseError, testing::Values(2, 3));

TEST_P(NoiseError, IsThatOf999OfAThousandPlaces) {
    double squares = 0;
    for (int i = 0; i < kPlaces / 4; ++i) squares += std::pow(gradient(anywhere()), 2);
    const double gradient = std::sqrt(squares / (kPlaces / 4));
    const auto compare = [&](const auto& texels, const NoiseFormat& format) {
        std::vector<double> errors;
        for (int i = 0; i < kPlaces; ++i) {
            const Place place = anywhere();
            errors.push_back(std::abs(filtered(texels, format.size, place) - exact(place)));
        }
        std::sort(errors.begin(), errors.end());
        const double measured = errors[kPlaces / 1000 * 999] / gradient;
        // 32 texels do not contain the finest octave of 32 cells at all, so the error is as large as the
        // octave.
        const double model = noiseError(dimensions(), format);
        EXPECT_LE(measured, model * 1.1) << format.size;
        EXPECT_GE(measured, model * (format.size == 32 ? .5 : .8)) << format.size;
    };
    for (const int size : noiseSizes(dimensions())) {
        compare(bytes(size), {size, scene::NoiseTexels::bytes});
        if (size <= 256) compare(shorts(size), {size, scene::NoiseTexels::shorts});
    }
}

TEST_P(NoiseError, TheMeanStepIsThatBetweenTheProbesSizes) {
    double gradients = 0;
    for (int i = 0; i < kPlaces / 4; ++i) gradients += gradient(anywhere());
    gradients /= kPlaces / 4;
    const auto [small, large] = kNoiseProbeSizes;
    const auto coarse = shorts(small), fine = shorts(large);
    double changes = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const Place place = anywhere();
        changes += std::abs(filtered(coarse, small, place) - filtered(fine, large, place));
    }
    EXPECT_NEAR(changes / kPlaces / gradients / meanNoiseStep(dimensions()), 1, .05);
}

TEST(SamplingModel, TakesTheSmallestNoiseThatKeepsTheBoundAndThenBytes) {
    for (const int dimensions : {2, 3})
        for (const double period : {1., 10., 100., 400.})
            for (const double bound : {.1, .25, 1., 4.}) {
                const NoiseFormat chosen = leastNoise(dimensions, bound, [&](const NoiseFormat& format) {
                    return noiseError(dimensions, format) * period;
                });
                const auto sizes = noiseSizes(dimensions);
                const auto keeps = [&](int size, scene::NoiseTexels texels) {
                    return noiseError(dimensions, {size, texels}) * period <= bound;
                };
                EXPECT_TRUE(keeps(chosen.size, chosen.texels) || chosen.size == sizes.back());
                const auto at = std::find(sizes.begin(), sizes.end(), chosen.size);
                EXPECT_TRUE(at == sizes.begin() || !keeps(*(at - 1), scene::NoiseTexels::shorts));
                EXPECT_EQ(chosen.texels == scene::NoiseTexels::bytes,
                          keeps(chosen.size, scene::NoiseTexels::bytes));
            }
}

}  // namespace
}  // namespace glibra::budget
