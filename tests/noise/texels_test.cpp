// The texels of the noise textures: table 9.1, the byte rule, sizes, threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "noise/noise.h"

namespace glibra::noise {
namespace {

struct Statistics {
    double mean = 0, deviation = 0, smallest = 1, largest = 0;
};

/// Statistics of one component (0..3), or of the sum of all four (4).
Statistics statisticsOf(const TexelBytes& texels, std::size_t component) {
    Statistics result{0, 0, 4, 0};
    double squares = 0;
    const double count = static_cast<double>(texels.size()) / 4;
    for (std::size_t at = 0; at < texels.size(); at += 4) {
        double value = 0;
        for (std::size_t c = 0; c < 4; ++c)
            if (component == 4 || component == c) value += texels[at + c] / 255.;
        result.mean += value;
        squares += value * value;
        result.smallest = std::min(result.smallest, value);
        result.largest = std::max(result.largest, value);
    }
    result.mean /= count;
    result.deviation = std::sqrt(squares / count - result.mean * result.mean);
    return result;
}

struct Expected {
    double smallest, largest, deviation;
};

// Table 9.1 gives the values of glman's bytes to three digits. A single texel may differ by one byte, which
// is 1/255 = .004 (9.3).
constexpr double kByte = 1.05 / 255;

TEST(NoiseTexels, HaveGlmansStatisticsIn3D) {
    const auto texels = noise3Texels(64);
    const Expected expected[] = {
        {.290, .671, .0656}, {.400, .604, .0318}, {.443, .553, .0167}, {.467, .525, .0075}};
    for (std::size_t c = 0; c < 4; ++c) {
        const Statistics found = statisticsOf(texels, c);
        EXPECT_NEAR(found.mean, .498, .0006) << c;
        EXPECT_NEAR(found.smallest, expected[c].smallest, kByte) << c;
        EXPECT_NEAR(found.largest, expected[c].largest, kByte) << c;
        EXPECT_NEAR(found.deviation, expected[c].deviation, 6e-5) << c;
    }
    const Statistics sum = statisticsOf(texels, 4);
    EXPECT_NEAR(sum.mean, 1.992, .001);
    EXPECT_NEAR(sum.smallest, 1.70, .01);
    EXPECT_NEAR(sum.largest, 2.27, .01);
}

TEST(NoiseTexels, HaveGlmansStatisticsIn2D) {
    const auto texels = noise2Texels(64);
    const Expected expected[] = {
        {.333, .647, .0743}, {.424, .569, .0238}, {.463, .537, .0137}, {.475, .522, .0070}};
    for (std::size_t c = 0; c < 4; ++c) {
        const Statistics found = statisticsOf(texels, c);
        EXPECT_NEAR(found.mean, .498, .0011) << c;
        EXPECT_NEAR(found.smallest, expected[c].smallest, kByte) << c;
        EXPECT_NEAR(found.largest, expected[c].largest, kByte) << c;
        EXPECT_NEAR(found.deviation, expected[c].deviation, 1e-4) << c;
    }
    const Statistics sum = statisticsOf(texels, 4);
    EXPECT_NEAR(sum.mean, 1.992, .002);
    EXPECT_NEAR(sum.smallest, 1.76, .01);
    EXPECT_NEAR(sum.largest, 2.20, .01);
}

/// True if `byte` is floor(255 * value). If rounding errors could change that byte, both bytes are accepted.
bool isByteOf(std::uint8_t byte, double value) {
    return byte == std::floor(255 * value - 1e-11) || byte == std::floor(255 * value + 1e-11);
}

TEST(NoiseTexels, AreTheFunctionAtTexelIndicesForAnySize) {
    for (const int n : {1, 5, 7, 32, 33, 50, 70}) {
        const auto texels = noise3Texels(n);
        ASSERT_EQ(texels.size(), static_cast<std::size_t>(4 * n * n * n));
        std::size_t at = 0, wrong = 0;
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    for (int octave = 0; octave < kOctaves; ++octave) {
                        const double step = static_cast<double>(cellsOf(octave)) / n;
                        wrong += !isByteOf(texels[at++], noise3(i * step, j * step, k * step, octave));
                    }
        EXPECT_EQ(wrong, 0U) << n;
    }
}

TEST(NoiseTexels, AreTheFunctionAtTexelIndicesIn2D) {
    for (const int n : {1, 4, 9, 64, 100, 333}) {
        const auto texels = noise2Texels(n);
        ASSERT_EQ(texels.size(), static_cast<std::size_t>(4 * n * n));
        std::size_t at = 0, wrong = 0;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (int octave = 0; octave < kOctaves; ++octave) {
                    const double step = static_cast<double>(cellsOf(octave)) / n;
                    wrong += !isByteOf(texels[at++], noise2(i * step, j * step, octave));
                }
        EXPECT_EQ(wrong, 0U) << n;
    }
}

TEST(NoiseTexels, Are127AtLatticePoints) {
    const auto texels = noise3Texels(64);
    for (std::size_t octave = 0; octave < 4; ++octave) {
        const std::size_t step = std::size_t{16} >> octave;
        for (std::size_t k = 0; k < 64; k += step)
            for (std::size_t j = 0; j < 64; j += step)
                for (std::size_t i = 0; i < 64; i += step)
                    ASSERT_EQ(texels[4 * (i + 64 * (j + 64 * k)) + octave], 127);
    }
}

TEST(NoiseTexels, OfASizeAreEverySecondTexelOfTheDoubleSize) {
    for (const int n : {20, 48}) {
        const auto small = noise3Texels(n), large = noise3Texels(2 * n);
        const auto size = static_cast<std::size_t>(n);
        for (std::size_t k = 0; k < size; ++k)
            for (std::size_t j = 0; j < size; ++j)
                for (std::size_t i = 0; i < 4 * size; ++i) {
                    const std::size_t twice = 8 * (i / 4) + i % 4;
                    ASSERT_EQ(small[i + 4 * size * (j + size * k)],
                              large[twice + 8 * size * (2 * j + 4 * size * k)]);
                }
    }
    const auto small = noise2Texels(75), large = noise2Texels(150);
    for (std::size_t j = 0; j < 75; ++j)
        for (std::size_t i = 0; i < 300; ++i)
            ASSERT_EQ(small[i + 300 * j], large[8 * (i / 4) + i % 4 + 1200 * j]);
}

TEST(NoiseTexels, DoNotDependOnTheNumberOfThreads) {
    const auto alone = noise3Texels(37, 1);
    for (const int threads : {0, 2, 3, 8, 100}) EXPECT_EQ(noise3Texels(37, threads), alone) << threads;
    const auto flat = noise2Texels(130, 1);
    for (const int threads : {0, 2, 5, 200}) EXPECT_EQ(noise2Texels(130, threads), flat) << threads;
}

TEST(NoiseTexels, ThatFloatsCannotDecideAreMarked) {
    // Rows with a single value, in units of 1/4096 byte above 1/2: close to the ends of a byte, and in its
    // middle.
    constexpr float kToWhole = (1 << kFractionBits) / 2;
    for (const auto& [units, inDoubt] :
         {std::pair(kToWhole, true), std::pair(kToWhole + .75F, true), std::pair(kToWhole - .75F, true),
          std::pair(kToWhole + 1.5F, false), std::pair(kToWhole - 1.5F, false), std::pair(0.F, false)}) {
        const std::array<float, 2> zero{};
        const std::array<float, 2> level{units, 0};
        const OctaveRow plain{{zero.data(), zero.data()}, {zero.data(), zero.data()}, {1, 0, 0, 0}};
        for (std::size_t octave = 0; octave < 4; ++octave) {
            std::array<OctaveRow, 4> rows{plain, plain, plain, plain};
            rows[octave].levels[0] = level.data();
            TexelBlock block{};
            EXPECT_EQ(combineOctaves(rows, 0, 2, block), inDoubt) << units;
            EXPECT_EQ(block.doubts[0] == 0, inDoubt) << units;
            EXPECT_NE(block.doubts[1], 0U);
        }
    }
}

TEST(NoiseTexels, OfASizeOutOfRangeAreEmpty) {
    EXPECT_TRUE(noise3Texels(0).empty());
    EXPECT_TRUE(noise3Texels(-5).empty());
    EXPECT_TRUE(noise3Texels(kLargestSize3 + 1).empty());
    EXPECT_TRUE(noise2Texels(0).empty());
    EXPECT_TRUE(noise2Texels(kLargestSize2 + 1).empty());
    std::vector<std::uint8_t> texels(4 * 8 * 8 * 8, 9);
    EXPECT_FALSE(writeNoise3(7, texels));
    EXPECT_FALSE(writeNoise2(8, texels));
    EXPECT_FALSE(writeNoise3(0, texels));
    EXPECT_EQ(texels, std::vector<std::uint8_t>(texels.size(), 9));
}

TEST(NoiseTexels, InSixteenBitsAreTheFunctionMinusHalfAByteStep) {
    for (const int n : {7, 64, 100}) {
        const TexelShorts solid = noise3Shorts(n), flat = noise2Shorts(n);
        ASSERT_EQ(solid.size(), 4U * static_cast<std::size_t>(n * n * n));
        ASSERT_EQ(flat.size(), 4U * static_cast<std::size_t>(n * n));
        double worst = 0;
        for (int i = 0; i < n * n * n; i += 37) {
            const int x = i % n, y = i / n % n, z = i / n / n;
            for (int octave = 0; octave < kOctaves; ++octave) {
                const double cells = static_cast<double>(cellsOf(octave)) / n;
                const auto component = static_cast<std::size_t>(octave);
                const auto off = [&](std::uint16_t texel, double value) {
                    worst = std::max(worst, std::abs(texel - (value - .5 / 255) * 65535));
                };
                off(solid[4 * static_cast<std::size_t>(i) + component],
                    noise3(x * cells, y * cells, z * cells, octave));
                off(flat[4 * static_cast<std::size_t>(x + n * y) + component],
                    noise2(x * cells, y * cells, octave));
            }
        }
        EXPECT_LT(worst, .55) << n;
    }
    EXPECT_TRUE(noise3Shorts(0).empty());
    EXPECT_TRUE(noise2Shorts(kLargestSize2 + 1).empty());
}

TEST(NoiseTexels, InSixteenBitsDoNotDependOnTheThreads) {
    EXPECT_EQ(noise3Shorts(33, 1), noise3Shorts(33, 5));
    EXPECT_EQ(noise2Shorts(257, 1), noise2Shorts(257, 3));
}

}  // namespace
}  // namespace glibra::noise
