// Values of Bound variables, with pictures whose error is a formula.

#include "budget/choose_bounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glibra::budget {
namespace {

BoundVariable variableOf(const std::string& name, double coarsest, double current, double finest) {
    return {.name = name,
            .coarsest = coarsest,
            .current = current,
            .finest = finest,
            .isWhole = true,
            .place = {"a.glib", 3, 1}};
}

/// A request whose pictures are `errorOf(values)` pixels off the limit, all in one direction.
BoundRequest requestOf(std::vector<BoundVariable> variables, double maxError,
                       std::function<double(std::span<const double>)> errorOf) {
    BoundRequest request;
    request.variables = std::move(variables);
    request.maxError = maxError;
    request.resolution = .001;
    request.change = [errorOf = std::move(errorOf)](std::span<const double> values,
                                                    std::span<const double> finest) {
        return PictureChange{std::abs(errorOf(values) - errorOf(finest)), 0};
    };
    return request;
}

std::string allTexts(const ChosenBounds& chosen) {
    std::string text;
    for (const Decision& each : chosen.decisions) text += each.what + ": " + each.why + "\n";
    for (const Diagnostic& each : chosen.diagnostics) text += each.id + ": " + each.text + "\n";
    return text;
}

TEST(BoundSteps, DoubleOrHalveFromEndToEnd) {
    EXPECT_EQ(boundSteps(variableOf("n", 8, 64, 512)), (std::vector<double>{8, 16, 32, 64, 128, 256, 512}));
    EXPECT_EQ(boundSteps(variableOf("n", 8, 2, 1)), (std::vector<double>{8, 4, 2, 1}));
    EXPECT_EQ(boundSteps(variableOf("n", 4, 4, 5)), (std::vector<double>{4, 5}));
    EXPECT_EQ(boundSteps(variableOf("n", 10, 60, 200)).size(), 5U);  // 10 21 45 95 200
    BoundVariable fraction = variableOf("n", .1, .05, .025);
    fraction.isWhole = false;
    EXPECT_EQ(boundSteps(fraction).size(), 3U);
    EXPECT_NEAR(boundSteps(fraction)[1], .05, 1e-12);
}

TEST(ChooseBounds, TakesTheCheapestValueWhoseTrueErrorKeepsTheBound) {
    // Whatever the order of the method: the error that is claimed, with that of the finest value, is at least
    // the true one, and one step coarser would not keep the bound.
    for (const double order : {1., 2., 4.})
        for (const double maxError : {.01, .1, .25, 1., 4.}) {
            const auto errorOf = [&](std::span<const double> values) {
                return 10 / std::pow(values[0], order);
            };
            const BoundVariable steps = variableOf("steps", 8, 64, 4096);
            const ChosenBounds chosen = chooseBounds(requestOf({steps}, maxError, errorOf));
            ASSERT_EQ(chosen.diagnostics.size(), 0U) << allTexts(chosen);
            EXPECT_LE(errorOf(chosen.values), maxError) << order << allTexts(chosen);
            const std::vector<double> coarser{chosen.values[0] / 2};
            if (coarser[0] >= 8) {
                EXPECT_GT(errorOf(coarser), .9 * maxError) << order << allTexts(chosen);
            }
        }
}

TEST(ChooseBounds, SharesTheBoundBetweenVariables) {
    const auto errorOf = [](std::span<const double> values) { return 8 / values[0] + 20 / values[1]; };
    const ChosenBounds chosen =
        chooseBounds(requestOf({variableOf("a", 4, 4, 1024), variableOf("b", 4, 4, 4096)}, 1, errorOf));
    EXPECT_LE(errorOf(chosen.values), 1);
    EXPECT_LT(chosen.values[0], 1024);
    EXPECT_LT(chosen.values[1], 4096);
}

TEST(ChooseBounds, AllowsACoarserMapOnceItsOffsetIsLarger) {
    // Acne where the offset is less than a texel: far too much error. The offset comes after the map.
    const auto errorOf = [](std::span<const double> values) {
        const double texel = 1024 / values[0], offset = values[1];
        return offset < texel ? 50. : .01 * offset + .01 * texel;
    };
    const ChosenBounds chosen = chooseBounds(
        requestOf({variableOf("map", 64, 512, 1024), variableOf("offset", 16, 4, 2)}, .5, errorOf));
    EXPECT_LT(chosen.values[0], 512) << allTexts(chosen);
    EXPECT_GT(chosen.values[1], 4) << allTexts(chosen);
    EXPECT_LE(errorOf(chosen.values), .5);
}

TEST(ChooseBounds, ChoosesNothingWhereThePictureDoesNotSettle) {
    // Noise that is new for each value.
    const auto noise = [](std::span<const double> values) { return 3 * std::sin(1e4 * values[0]); };
    const ChosenBounds chosen = chooseBounds(requestOf({variableOf("n", 8, 64, 512)}, .25, noise));
    EXPECT_EQ(chosen.values, std::vector{64.});
    ASSERT_EQ(chosen.diagnostics.size(), 1U);
    EXPECT_EQ(chosen.diagnostics[0].id, "draw-W07");
    EXPECT_NE(chosen.decisions[0].why.find("64 kept: its error is not known"), std::string::npos);
    // The other variable is chosen all the same.
    const auto half = [&](std::span<const double> values) { return noise(values) + 16 / values[1]; };
    const ChosenBounds both =
        chooseBounds(requestOf({variableOf("n", 8, 64, 512), variableOf("m", 4, 4, 4096)}, 1, half));
    EXPECT_EQ(both.values[0], 64);
    EXPECT_GE(both.values[1], 16) << allTexts(both);
    EXPECT_LT(both.values[1], 256) << allTexts(both);
}

TEST(ChooseBounds, ClaimsNothingBelowWhatThePicturesShow) {
    BoundRequest request = requestOf({variableOf("n", 8, 64, 512)}, .25, [](auto) { return 0.; });
    request.resolution = .3;
    const ChosenBounds blind = chooseBounds(request);
    EXPECT_EQ(blind.values, std::vector{64.});
    EXPECT_EQ(blind.diagnostics.size(), 1U) << allTexts(blind);
    request.resolution = .1;
    EXPECT_EQ(chooseBounds(request).values, std::vector{8.});
}

TEST(ChooseBounds, KeepsWhatIsStatedAndWhatCannotBeDrawn) {
    BoundVariable given = variableOf("n", 8, 64, 512);
    given.isGiven = true;
    BoundRequest request = requestOf({given}, .25, [](auto values) { return 1 / values[0]; });
    EXPECT_EQ(allTexts(chooseBounds(request)), "n: 64 kept: stated by --set\n");
    request = requestOf({variableOf("n", 8, 64, 512)}, .25, {});
    request.change = [](auto, auto) -> Result<PictureChange> {
        return diagnose("gpu-E04", "too large", {"a.glib", 1, 1});
    };
    const ChosenBounds chosen = chooseBounds(request);
    EXPECT_EQ(chosen.values, std::vector{64.});
    EXPECT_NE(allTexts(chosen).find("cannot be drawn: too large"), std::string::npos) << allTexts(chosen);
    EXPECT_EQ(chosen.diagnostics.size(), 1U);
}

TEST(ChooseBounds, LooksAtColoursThatAreNoContours) {
    BoundRequest request = requestOf({variableOf("n", 8, 8, 512)}, 1, [](auto) { return 0.; });
    request.change = [](std::span<const double> values, std::span<const double> finest) {
        return PictureChange{0, .1 / values[0] - .1 / finest[0]};
    };
    const double chosen = chooseBounds(request).values[0];
    EXPECT_LE(.1 / chosen - .1 / 512, .001);
    EXPECT_EQ(chosen, 128);
}

}  // namespace
}  // namespace glibra::budget
