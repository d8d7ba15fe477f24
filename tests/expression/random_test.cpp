// rand and noise: the same bits on every machine, and the distribution that their names promise.

#include "expression/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support.h"

namespace glibra::expression::test {
namespace {

/// splitmix64 as its authors state it, with a state that is stepped.
struct SplitMix {
    std::uint64_t state;
    std::uint64_t next() {
        std::uint64_t z = (state += 0x9e3779b97f4a7c15U);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
};

TEST(ExpressionRandom, IsTheSequenceOfSplitMix) {
    for (const std::uint64_t seed : {0U, 1U, 7U, 123456U}) {
        SplitMix first{seed};
        SplitMix sequence{first.next()};  // mix(seed + c)
        for (int i = 1; i < 100; ++i)
            EXPECT_EQ(random(i, static_cast<double>(seed)),
                      static_cast<double>(sequence.next() >> 11) * 0x1p-53);
    }
}

TEST(ExpressionRandom, IsPinned) {
    EXPECT_EQ(numberOf("rand(0, 0)"), 0.28176129772258496);
    EXPECT_EQ(numberOf("rand(1, 0)"), 0.65244848637403219);
    EXPECT_EQ(numberOf("rand(-1, 7)"), 0.85836398913359435);
    EXPECT_EQ(numberOf("rand(1e15, -3)"), 0.72677491365242086);
    EXPECT_EQ(numberOf("rand(5)"), numberOf("rand(5, 0)"));
    EXPECT_EQ(numberOf("rand(5.9, 1.9)"), numberOf("rand(5, 1)")) << "cut toward zero";
    EXPECT_EQ(numberOf("rand(-.9, 1)"), numberOf("rand(0, 1)"));
    EXPECT_EQ(problemText("rand(1e19, 0)"),
              "expr-E06 'rand(1e19, 0)': 'rand(1e19, 0)': the arguments of rand are between -2^63 and 2^63");
}

TEST(ExpressionRandom, IsUniformAndUncorrelated) {
    constexpr int kCount = 100'000;
    std::array<int, 16> bins{};
    double sum = 0, neighbours = 0, seeds = 0;
    for (int i = 0; i < kCount; ++i) {
        const double value = *random(i, 3);
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        ++bins[static_cast<std::size_t>(value * 16)];
        sum += value;
        neighbours += (value - .5) * (*random(i + 1, 3) - .5);
        seeds += (value - .5) * (*random(i, 4) - .5);
    }
    EXPECT_NEAR(sum / kCount, .5, .004);
    EXPECT_NEAR(neighbours / kCount, 0, .0015);
    EXPECT_NEAR(seeds / kCount, 0, .0015);
    double chiSquare = 0;
    for (const int bin : bins) chiSquare += std::pow(bin - kCount / 16., 2) / (kCount / 16.);
    EXPECT_LT(chiSquare, 37.7) << "one in a thousand, for 15 degrees of freedom";
}

TEST(ExpressionNoise, IsPinned) {
    EXPECT_EQ(numberOf("noise(.5)"), -0.024628159025798513);
    EXPECT_EQ(numberOf("noise(-7.25)"), 0.21179080448907683);
    EXPECT_EQ(numberOf("noise(vec2(.25, 3.75))"), -0.04066385489028241);
    EXPECT_EQ(numberOf("noise(vec3(.1, -2.2, 30.3))"), -0.34189625627276149);
}

TEST(ExpressionNoise, IsZeroAtWholePointsAndStaysInRange) {
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
        double least = 0, most = 0, sum = 0;
        constexpr int kCount = 400'000;
        for (int i = 0; i < kCount; ++i) {
            const std::array<double, 3> point{*random(i, 1) * 1000 - 500, *random(i, 2) * 1000 - 500,
                                              *random(i, 3) * 1000 - 500};
            const double value = gradientNoise(point.data(), dimensions);
            least = std::min(least, value);
            most = std::max(most, value);
            sum += value;
            if (i < 100) {
                const std::array<double, 3> whole{std::floor(point[0]), std::floor(point[1]),
                                                  std::floor(point[2])};
                EXPECT_EQ(gradientNoise(whole.data(), dimensions), 0);
            }
        }
        EXPECT_GE(least, -1) << dimensions;
        EXPECT_LE(most, 1) << dimensions;
        EXPECT_LT(least, -.7) << dimensions;
        EXPECT_GT(most, .7) << dimensions;
        EXPECT_NEAR(sum / kCount, 0, .01) << dimensions;
    }
    const double far = 1e300;
    EXPECT_EQ(gradientNoise(&far, 1), 0);
}

TEST(ExpressionNoise, IsSmoothAcrossCells) {
    // The difference over a small step is near the slope on both sides of the cells' borders.
    for (int dimensions = 1; dimensions <= 3; ++dimensions)
        for (int i = 0; i < 300; ++i) {
            const double step = 1e-6;
            std::array<double, 3> point{static_cast<double>(i - 150), *random(i, 5) * 10, *random(i, 6) * 10};
            const double centre = gradientNoise(point.data(), dimensions);
            point[0] += step;
            const double right = gradientNoise(point.data(), dimensions);
            point[0] -= 2 * step;
            const double left = gradientNoise(point.data(), dimensions);
            EXPECT_NEAR(right - centre, centre - left, 1e-10) << dimensions;
            EXPECT_LT(std::abs(right - centre), 5e-6) << dimensions;
        }
}

}  // namespace
}  // namespace glibra::expression::test
