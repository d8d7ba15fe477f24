// The verdict on two pictures: each measure at its limit and just beyond.

#include "image/compare/judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/image.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::floatImage;

/// 64 x 64 pixels of one value, RGB.
Image grey(int value) {
    return {64, 64, 3, Component::u8,
            std::vector<std::byte>(std::size_t{64} * 64 * 3, static_cast<std::byte>(value))};
}

void change(Image& image, int x, int y, int by, std::size_t component = 0) {
    auto& byte =
        image
            .data[static_cast<std::size_t>(y * image.width + x) * static_cast<std::size_t>(image.components) +
                  component];
    byte = static_cast<std::byte>(std::to_integer<int>(byte) + by);
}

/// No limits except those that a test sets.
Tolerance loose() {
    Tolerance tolerance;
    tolerance.fraction = 1;
    tolerance.cluster = tolerance.line = 1 << 20;
    tolerance.bias = 255;
    return tolerance;
}

TEST(Judge, EqualBytesNeedNoFigures) {
    const Image image = testing::noisyImage(9, 7, 4, Component::u16);
    const Judgement result = judge(image, image, exactTolerance());
    EXPECT_TRUE(result.same);
    EXPECT_EQ(result.decidedBy, Rung::bytes);
    EXPECT_EQ(result.reason, "equal");
    EXPECT_FALSE(result.flip || result.structure);
}

TEST(Judge, EqualValuesInOtherTypesAreTheSame) {
    const Image image = testing::noisyImage(9, 7, 3, Component::u8);
    EXPECT_TRUE(judge(image, withComponents(image, 4), exactTolerance()).same);
    EXPECT_TRUE(judge(withType(image, Component::u16), image, exactTolerance()).same);
}

TEST(Judge, OtherSizesDifferAndSayHow) {
    const Judgement result = judge(grey(1), testing::noisyImage(9, 7, 3, Component::u8), loose());
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.decidedBy, Rung::size);
    EXPECT_EQ(result.reason, "the sizes differ: expected 64 x 64, found 9 x 7");
    EXPECT_FALSE(result.comparison.sameSize);
    EXPECT_FALSE(judge({}, {}, loose()).same) << "pictures without pixels are no pictures";
}

TEST(Judge, LargestDifferenceIsAllowedAndOneMoreIsNot) {
    for (const Component type : {Component::u8, Component::u16, Component::f32}) {
        Tolerance tolerance = loose();
        tolerance.largest = 3;
        tolerance.fraction = 0;
        Image b = grey(100);
        change(b, 5, 6, 3);
        const Image a = withType(grey(100), type);
        EXPECT_TRUE(judge(a, b, tolerance).same) << judge(a, b, tolerance).reason;
        change(b, 5, 6, 1);
        const Judgement result = judge(a, b, tolerance);
        EXPECT_FALSE(result.same);
        EXPECT_EQ(result.decidedBy, Rung::differences);
        EXPECT_EQ(result.beyond, 1U);
        EXPECT_EQ(result.comparison.x, 5);
        EXPECT_EQ(result.comparison.y, 6);
        EXPECT_NE(result.reason.find("1 pixel differs by more than "), std::string::npos) << result.reason;
    }
}

TEST(Judge, AlphaCounts) {
    const Image a = withComponents(grey(100), 4);
    Image b = a;
    change(b, 5, 6, -4, 3);
    Tolerance tolerance;
    tolerance.fraction = 0;
    EXPECT_FALSE(judge(a, b, tolerance).same);
    EXPECT_FALSE(judge(grey(100), b, tolerance).same) << "the picture without alpha is opaque";
}

TEST(Judge, FractionCountsPixelsNotComponents) {
    Tolerance tolerance = loose();
    tolerance.fraction = 2. / (64 * 64);
    Image b = grey(100);
    for (const std::size_t component : {0U, 1U, 2U}) change(b, 5, 6, 90, component);
    change(b, 20, 6, 90);
    EXPECT_TRUE(judge(grey(100), b, tolerance).same);
    change(b, 40, 6, 90);
    const Judgement result = judge(grey(100), b, tolerance);
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.beyond, 3U);
}

TEST(Judge, PixelsThatTouchAreAShape) {
    Tolerance tolerance = loose();
    tolerance.cluster = 4;
    Image b = grey(100);
    // A diagonal through the corner at the right edge of the picture; (0, y + 1) is not a neighbour of (63,
    // y).
    for (const auto& [x, y] : {std::pair{60, 10}, {61, 11}, {62, 12}, {63, 13}, {0, 14}, {0, 13}})
        change(b, x, y, 90);
    EXPECT_EQ(judge(grey(100), b, tolerance).cluster, 4U);
    EXPECT_TRUE(judge(grey(100), b, tolerance).same);
    change(b, 62, 14, 90);
    const Judgement result = judge(grey(100), b, tolerance);
    EXPECT_FALSE(result.same);
    EXPECT_EQ(result.decidedBy, Rung::differences);
    EXPECT_EQ(result.cluster, 5U);
    EXPECT_EQ(result.clusterX, 60);
    EXPECT_EQ(result.clusterY, 10);
}

TEST(Judge, PixelsOfOneRowOrColumnAreALine) {
    for (const bool row : {true, false}) {
        Tolerance tolerance = loose();
        tolerance.line = 5;
        Image b = grey(100);
        for (int i = 0; i < 5; ++i) row ? change(b, 3 + 7 * i, 9, 90) : change(b, 9, 3 + 7 * i, 90);
        change(b, 50, 50, 90);
        EXPECT_TRUE(judge(grey(100), b, tolerance).same);
        row ? change(b, 60, 9, 90) : change(b, 9, 60, 90);
        const Judgement result = judge(grey(100), b, tolerance);
        EXPECT_FALSE(result.same);
        EXPECT_EQ(result.decidedBy, Rung::differences);
        EXPECT_EQ(result.line, 6U);
        EXPECT_NE(result.reason.find(row ? "6 pixels in row 9 differ" : "6 pixels in column 9 differ"),
                  std::string::npos)
            << result.reason;
    }
}

TEST(Judge, BiasSeesASmallChangeOfManyPixelsAndNotNoise) {
    Image noisy = grey(100);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) change(noisy, x, y, (x + y) % 2 == 0 ? 3 : -3, 1);
    const Judgement noise = judge(grey(100), noisy, Tolerance{});
    EXPECT_TRUE(noise.same) << noise.reason;
    EXPECT_NEAR(noise.bias, 0, 1e-12);
    EXPECT_TRUE(judge(grey(100), grey(101), Tolerance{}).same) << "rounding falls to the other side";
    Image brighter = grey(100);
    for (int y = 16; y < 32; ++y)
        for (int x = 32; x < 48; ++x) change(brighter, x, y, -1 - (x + y) % 2, 2);
    for (const Component type : {Component::u8, Component::u16}) {
        const Judgement result = judge(withType(grey(100), type), brighter, Tolerance{});
        EXPECT_FALSE(result.same);
        EXPECT_EQ(result.decidedBy, Rung::bias);
        EXPECT_NEAR(result.bias, 1.5, 1e-9);
        EXPECT_EQ(result.biasX, 32);
        EXPECT_EQ(result.biasY, 16);
    }
}

TEST(Judge, SinglePixelsBeyondTheLimitDoNotDecideTheBias) {
    Image b = grey(100);
    for (int i = 0; i < 8; ++i) change(b, 3 * i, 5, 150);
    Tolerance tolerance = loose();
    tolerance.bias = 1;
    const Judgement result = judge(grey(100), b, tolerance);
    EXPECT_TRUE(result.same) << result.reason;
    EXPECT_NEAR(result.bias, 6 * 3. / 256, 1e-12) << "six of them in the first block, 3 each";
}

TEST(Judge, BlocksAtTheEdgesIncludeTheRemainder) {
    const Image a{40, 20, 1, Component::u8, std::vector<std::byte>(800, std::byte{50})};
    Image b = a;
    change(b, 39, 19, 2);
    const Judgement result = judge(a, b, Tolerance{});
    EXPECT_EQ(result.biasX, 16);
    EXPECT_EQ(result.biasY, 0);
    EXPECT_NEAR(result.bias, 2. / (24 * 20), 1e-12);
}

TEST(Judge, FloatPicturesAreComparedRelativelyAndAbsolutely) {
    Tolerance tolerance = loose();
    tolerance.fraction = 0;
    tolerance.relative = 0.01;
    tolerance.absolute = 0.5;
    const Image a = floatImage(2, 1, 1, {1000, 0});
    EXPECT_TRUE(judge(a, floatImage(2, 1, 1, {1010, 0}), tolerance).same);
    EXPECT_TRUE(judge(a, floatImage(2, 1, 1, {990, .5F}), tolerance).same);
    EXPECT_FALSE(judge(a, floatImage(2, 1, 1, {1011, 0}), tolerance).same);
    EXPECT_FALSE(judge(a, floatImage(2, 1, 1, {1000, .51F}), tolerance).same);
    EXPECT_FALSE(judge(floatImage(1, 1, 1, {.5F}), floatImage(1, 1, 1, {.5005F}), Tolerance{}).same);
    EXPECT_TRUE(judge(floatImage(1, 1, 1, {.5F}), floatImage(1, 1, 1, {.50004F}), Tolerance{}).same);
}

TEST(Judge, NanAndInfinityEqualThemselvesAndAreReported) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    const Image a = floatImage(3, 1, 1, {nan, infinity, 1});
    const Judgement equal = judge(a, a, exactTolerance());
    EXPECT_TRUE(equal.same);
    EXPECT_EQ(equal.comparison.nonFinite, 2U);
    EXPECT_EQ(equal.reason, "equal, but 2 components are NaN or infinite");
    Tolerance tolerance = loose();
    tolerance.fraction = 0;
    EXPECT_TRUE(judge(a, floatImage(3, 1, 1, {nan, infinity, 1.00001F}), tolerance).same);
    EXPECT_FALSE(judge(a, floatImage(3, 1, 1, {1, infinity, 1}), tolerance).same);
    EXPECT_FALSE(judge(a, floatImage(3, 1, 1, {nan, -infinity, 1}), tolerance).same);
    tolerance.relative = 1e30;
    EXPECT_FALSE(judge(a, floatImage(3, 1, 1, {nan, 1, 1}), tolerance).same)
        << "no tolerance reaches infinity";
    const Image bytes{3, 1, 1, Component::u8, testing::bytesOf({0, 255, 255})};
    EXPECT_EQ(judge(a, bytes, tolerance).beyond, 2U);
}

/// A white square on black, moved by `shift`.
Image square(int shift, int side = 24) {
    Image image = grey(0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (const std::size_t component : {0U, 1U, 2U})
                change(image, 20 + x + shift, 20 + y, 255, component);
    return image;
}

TEST(Judge, StructurePassesAMovedEdgeAndFailsAMissingShape) {
    Tolerance tolerance;
    EXPECT_FALSE(judge(square(0), square(1), tolerance).same);
    tolerance.structure = 0.05;
    const Judgement moved = judge(square(0), square(1), tolerance);
    EXPECT_TRUE(moved.same) << moved.reason;
    EXPECT_EQ(moved.decidedBy, Rung::structure);
    const Judgement shrunk = judge(square(0), square(0, 18), tolerance);
    EXPECT_FALSE(shrunk.same);
    EXPECT_EQ(shrunk.decidedBy, Rung::structure);
    EXPECT_FALSE(shrunk.flip.has_value());
}

TEST(Judge, FlipDecidesIfItIsRequested) {
    Tolerance tolerance;
    const double mean = *judge(square(0), square(1), tolerance, true).flip;
    tolerance.flip = mean * 1.01;
    EXPECT_TRUE(judge(square(0), square(1), tolerance).same);
    EXPECT_EQ(judge(square(0), square(1), tolerance).decidedBy, Rung::flip);
    tolerance.flip = mean * 0.99;
    EXPECT_FALSE(judge(square(0), square(1), tolerance).same);
    tolerance.flip = 1;
    tolerance.structure = 0;
    const Judgement both = judge(square(0), square(0, 18), tolerance);
    EXPECT_FALSE(both.same) << "both have to hold";
    EXPECT_EQ(both.decidedBy, Rung::structure);
}

TEST(Judge, EverythingIsComputedForAReport) {
    Image b = grey(100);
    change(b, 3, 3, 1);
    const Judgement result = judge(grey(100), b, Tolerance{}, true);
    EXPECT_TRUE(result.same);
    EXPECT_EQ(result.decidedBy, Rung::differences);
    EXPECT_TRUE(result.flip && result.structure);
    EXPECT_FALSE(judge(grey(100), b, Tolerance{}).flip.has_value());
}

// Changes that a person sees, at the default tolerance.

/// A lit ball in front of a dark background, as in a scene; `brightness` scales the light.
Image ball(double brightness, double gamma) {
    Image image{200, 200, 3, Component::u8, {}};
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {
            const double u = (x - 99.5) / 80, v = (y - 99.5) / 80, r2 = u * u + v * v;
            const double light =
                r2 < 1 ? .1 + .85 * brightness * std::max(0., std::sqrt(1 - r2) * .8 - .5 * v) : .05;
            for (const double color : {1., .6, .3}) {
                const double value = std::pow(std::min(light * color, 1.), gamma);
                image.data.push_back(static_cast<std::byte>(std::lround(value * 255)));
            }
        }
    return image;
}

TEST(JudgeByDefault, GammaAndBrightnessOfTwoPercentAreSeen) {
    EXPECT_FALSE(judge(ball(1, 1), ball(1, 1.02), Tolerance{}).same);
    EXPECT_FALSE(judge(ball(1, 1), ball(1.02, 1), Tolerance{}).same);
    EXPECT_TRUE(judge(ball(1, 1), ball(1.001, 1), Tolerance{}).same);
}

TEST(JudgeByDefault, ALostTriangleIsSeen) {
    Image b = ball(1, 1);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x <= y; ++x)
            for (const std::size_t component : {0U, 1U, 2U})
                b.data[static_cast<std::size_t>((60 + y) * 200 + 60 + x) * 3 + component] = std::byte{13};
    const Judgement result = judge(ball(1, 1), b, Tolerance{});
    EXPECT_EQ(result.cluster, 10U) << "fewer pixels than may differ, but together";
    EXPECT_FALSE(result.same);
}

TEST(JudgeByDefault, APictureMovedByOneRowIsSeen) {
    const Image a = ball(1, 1);
    Image b = a;
    std::memmove(b.data.data() + b.rowBytes(), b.data.data(), b.data.size() - b.rowBytes());
    EXPECT_FALSE(judge(a, b, Tolerance{}).same);
}

/// A tolerance that only a difference in range can meet: the perceptual measures pass everything.
Tolerance perceptual(std::optional<double> flipLimit, std::optional<double> structureLimit) {
    Tolerance tolerance;
    tolerance.flip = flipLimit;
    tolerance.structure = structureLimit;
    return tolerance;
}

/// All pairs of values, as whole pictures and as single pixels, under every combination of measures.
TEST(JudgeFloats, PassOnlyWhereAMeasureSeesTheDifference) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> values{0,    .25F,  1,     1.0001F, 1.5F,   2,        50,        100,
                                    -.5F, -1.5F, 3e38F, -3e38F,  1e-30F, infinity, -infinity, nan};
    const auto isFinite = [](float value) { return std::isfinite(value); };
    const auto isInRange = [](float value) { return value >= 0 && value <= 1; };
    constexpr int kSide = 16;
    const Tolerance tolerances[] = {perceptual(1, {}), perceptual({}, 1), perceptual(1, 1),
                                    perceptual(.05, .05), [] {
                                        Tolerance all = loose();  // any number of pixels may differ
                                        all.flip = all.structure = 1;
                                        return all;
                                    }()};
    for (const float a : values)
        for (const float b : values)
            for (const bool isWhole : {true, false})
                for (const Tolerance& tolerance : tolerances) {
                    std::vector<float> expected(std::size_t{kSide} * kSide * 3, isWhole ? a : .5F),
                        got = expected;
                    if (isWhole) std::fill(got.begin(), got.end(), b);
                    expected[100] = a;
                    got[100] = b;
                    const Judgement result = judge(floatImage(kSide, kSide, 3, expected),
                                                   floatImage(kSide, kSide, 3, got), tolerance);
                    const std::string what =
                        fmt::format("{} and {}, whole {}, flip {}, fraction {}", a, b, isWhole,
                                    tolerance.flip.value_or(-1), tolerance.fraction);
                    const double limit =
                        tolerance.absolute + tolerance.relative * std::max(std::abs(a), std::abs(b));
                    const bool isEqual = a == b || (std::isnan(a) && std::isnan(b));
                    const bool mayDecide = isInRange(a) && isInRange(b) && tolerance.flip.value_or(1) == 1 &&
                                           tolerance.structure.value_or(1) == 1;
                    std::optional<bool> expectedSame;  // nothing: either, by the figures of the measures
                    if (isEqual)
                        expectedSame = true;
                    else if (!isFinite(a) || !isFinite(b))
                        expectedSame = false;
                    else if (std::abs(a - b) <= limit)
                        expectedSame = true;
                    else if (tolerance.fraction == 1 || mayDecide)
                        expectedSame = true;
                    else if (!isInRange(a) || !isInRange(b))
                        expectedSame = false;
                    EXPECT_EQ(result.same, expectedSame.value_or(result.same))
                        << what << ": " << result.reason;
                }
}

TEST(JudgeFloats, SayWhyAMeasureDoesNotDecide) {
    std::vector<float> bright(std::size_t{8} * 8 * 3, .02F), brighter(std::size_t{8} * 8 * 3, 1.F);
    EXPECT_TRUE(judge(floatImage(8, 8, 3, bright), floatImage(8, 8, 3, brighter), perceptual(1, {})).same);
    for (float& each : brighter) each = 50;
    for (float& each : bright) each = 1;
    const Judgement outside =
        judge(floatImage(8, 8, 3, bright), floatImage(8, 8, 3, brighter), perceptual(1, {}));
    EXPECT_FALSE(outside.same);
    EXPECT_NE(outside.reason.find("flip decides within 0..1 only"), std::string::npos) << outside.reason;
    brighter = bright;
    brighter[3 * 9] = std::numeric_limits<float>::quiet_NaN();
    const Judgement notFinite = judge(floatImage(8, 8, 3, bright), floatImage(8, 8, 3, brighter), loose());
    EXPECT_FALSE(notFinite.same);
    EXPECT_EQ(notFinite.reason, "a value is NaN or infinite, and not the same in both pictures, at 1, 1");
}

/// Values outside of 0..1 that agree do not keep the measures from judging the others.
TEST(JudgeFloats, BrightPixelsThatAgreeAreNoObstacle) {
    std::vector<float> expected(std::size_t{32} * 32 * 3, .5F);
    for (std::size_t i = 0; i < 300; ++i) expected[i] = 40;
    std::vector<float> got = expected;
    for (std::size_t i = 2000; i < 2060; ++i) got[i] = .52F;
    const Image a = floatImage(32, 32, 3, expected), b = floatImage(32, 32, 3, got);
    EXPECT_FALSE(judge(a, b, Tolerance()).same);
    EXPECT_TRUE(judge(a, b, perceptual(.05, {})).same);
}

/// An 8-bit picture has no values outside of 0..1, but the float picture beside it may.
TEST(JudgeFloats, AreHeldAgainstBytesToo) {
    const Image bytes{8, 8, 3, Component::u8, std::vector<std::byte>(std::size_t{192}, std::byte{255})};
    EXPECT_TRUE(judge(bytes, floatImage(8, 8, 3, std::vector<float>(192, 1)), perceptual(1, 1)).same);
    EXPECT_FALSE(judge(bytes, floatImage(8, 8, 3, std::vector<float>(192, 2)), perceptual(1, 1)).same);
}

}  // namespace
}  // namespace glibra::image
