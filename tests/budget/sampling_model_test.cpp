// Models of samples and noise against measurements.

#include "budget/sampling_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// A row of n samples at equal distances, the worst of the places that an edge across it can have.
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

/// What a linear filter gives from the bytes of the texture, with the half step that cutting to bytes takes
/// away on the average.
double filtered(const noise::TexelBytes& texels, int size, const std::vector<double>& place) {
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
            sum += weight * (texels[4 * at + octave] + .5) / 255;
    }
    return sum;
}

TEST(SamplingModel, NoiseErrorIsThatOf95OfAHundredPlaces) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const std::size_t dimensions : {2U, 3U}) {
        const auto anywhere = [&] {
            std::vector<double> place(dimensions);
            for (double& each : place) each = uniform(random);
            return place;
        };
        constexpr int kPlaces = 20000;
        double squares = 0;
        for (int i = 0; i < kPlaces; ++i) {
            const std::vector<double> place = anywhere();
            for (std::size_t axis = 0; axis < dimensions; ++axis) {
                constexpr double kStep = 1e-5;
                std::vector<double> low = place, high = place;
                low[axis] -= kStep;
                high[axis] += kStep;
                squares += std::pow((exact(high) - exact(low)) / (2 * kStep), 2);
            }
        }
        const double gradient = std::sqrt(squares / kPlaces);
        for (const int size : noiseSizes(static_cast<int>(dimensions))) {
            const noise::TexelBytes texels =
                dimensions == 3 ? noise::noise3Texels(size) : noise::noise2Texels(size);
            std::vector<double> errors;
            for (int i = 0; i < kPlaces; ++i) {
                const std::vector<double> place = anywhere();
                errors.push_back(std::abs(filtered(texels, size, place) - exact(place)));
            }
            std::sort(errors.begin(), errors.end());
            const double measured = errors[kPlaces * 95 / 100] / gradient;
            // The finest octave of 32 cells is not there at all in 32 texels: its error is its size.
            const double model = noiseError(static_cast<int>(dimensions), size);
            EXPECT_LE(measured, model * 1.1) << dimensions << " " << size;
            EXPECT_GE(measured, model * (size == 32 ? .5 : .85)) << dimensions << " " << size;
        }
    }
}

TEST(SamplingModel, TakesTheSmallestNoiseThatKeepsTheBound) {
    for (const int dimensions : {2, 3})
        for (const double period : {1., 10., 100., 400.})
            for (const double bound : {.1, .25, 1., 4.}) {
                const int size = leastNoiseSize(dimensions, period, bound);
                const auto sizes = noiseSizes(dimensions);
                EXPECT_TRUE(size == sizes.back() || noiseError(dimensions, size) * period <= bound);
                EXPECT_TRUE(size == sizes.front() || noiseError(dimensions, size / 2) * period > bound);
            }
}

}  // namespace
}  // namespace glibra::budget
