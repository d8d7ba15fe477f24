// The search for levels, with a known error: a constant divided by the square of the level.

#include "budget/least_counts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glibra::budget {
namespace {

/// One uniform at 8, from 1 to 64, whose true error is `pixels` / level^2.
LevelsRequest levelsRequest(double pixels, double maxError) {
    LevelsRequest made;
    made.uniforms = {{.uniform = plan::UniformIndex(3), .value = 8, .least = 1, .most = 64}};
    made.isFree = true;
    made.maxError = maxError;
    made.error = [pixels](std::span<const LevelValue> values) -> std::optional<double> {
        return pixels / std::pow(values[0].value, 2);
    };
    return made;
}

TEST(LeastLevels, AreTheLowestThatKeepTheBound) {
    for (const double maxError : {4., 1., .25}) {
        const auto found = leastLevels(levelsRequest(100, maxError));
        ASSERT_TRUE(found);
        EXPECT_TRUE(found->isKept);
        const double exact = std::sqrt(100 / maxError);
        EXPECT_GE(found->values[0].value, exact - 1e-9);
        EXPECT_LE(found->values[0].value, exact * 1.03);
        EXPECT_NEAR(found->pixels, 100 / std::pow(found->values[0].value, 2), 1e-9);
    }
}

TEST(LeastLevels, AreTheLeastOfTheRangeWhereThatIsEnough) {
    const auto found = leastLevels(levelsRequest(.1, .25));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->values[0].value, 1);
}

TEST(LeastLevels, AreTheMostWhereNothingIsEnough) {
    const auto found = leastLevels(levelsRequest(10'000, .25));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->values[0].value, 64);
    EXPECT_FALSE(found->isKept);
    EXPECT_NEAR(found->pixels, 10'000. / 64 / 64, 1e-9);
}

TEST(LeastLevels, ThatAreStatedStay) {
    LevelsRequest stated = levelsRequest(100, .25);
    stated.isFree = false;
    const auto found = leastLevels(stated);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->values[0].value, 8);
    EXPECT_FALSE(found->isKept);
    EXPECT_NEAR(found->pixels, 100. / 64, 1e-9);
}

TEST(LeastLevels, KeepTheirProportionsAsFarAsTheirRangesGo) {
    LevelsRequest two = levelsRequest(100, .25);
    two.uniforms = {{.uniform = plan::UniformIndex(0), .value = 8, .least = 1, .most = 64},
                    {.uniform = plan::UniformIndex(1), .value = 4, .least = 1, .most = 6}};
    const auto found = leastLevels(two);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->values[0].value, 20, .6);
    EXPECT_EQ(found->values[1].value, 6);
}

TEST(LeastLevels, AreNoneWhereNothingCanBeMeasured) {
    LevelsRequest blind = levelsRequest(100, .25);
    blind.error = [](auto) { return std::optional<double>(); };
    EXPECT_FALSE(leastLevels(blind));
}

}  // namespace
}  // namespace glibra::budget
