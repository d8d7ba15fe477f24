// The tolerance that is proposed for a picture that failed: it passes, and a step less does not.

#include "image/compare/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>

#include "image/bytes.h"
#include "image/image.h"
#include "support.h"

namespace glibra::image {
namespace {

Image noise(Component type = Component::u8) {
    return testing::noisyImage(96, 80, 3, type);
}

/// Changes each component of the pixels for which `chosen` is true by up to `most`.
Image changed(Image image, int most, unsigned seed, const std::function<bool(int, int)>& chosen) {
    std::minstd_rand random(seed);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const int by = static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
            if (!chosen(x, y)) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                auto& byte =
                    image.data[(static_cast<std::size_t>(y) * 96 + static_cast<std::size_t>(x)) * 3 + c];
                const int value = std::to_integer<int>(byte);
                byte = static_cast<std::byte>(value + by < 0 || value + by > 255 ? value - by : value + by);
            }
        }
    return image;
}

/// It passes; with any limit that was raised a step lower it does not.
void expectJustPasses(const Image& expected, const Image& got, const Tolerance& stated) {
    const Judgement failed = judge(expected, got, stated, true);
    ASSERT_FALSE(failed.same);
    const NearestTolerance nearest = nearestTolerance(expected, got, stated, failed);
    ASSERT_TRUE(nearest.tolerance) << nearest.whyNone;
    EXPECT_TRUE(nearest.whyNone.empty());
    const Tolerance& passes = *nearest.tolerance;
    EXPECT_TRUE(judge(expected, got, passes).same) << judge(expected, got, passes).reason;
    int raised = 0;
    const auto expectStepFails = [&](bool isRaised, const char* what,
                                     const std::function<void(Tolerance&)>& step) {
        if (!isRaised) return;
        ++raised;
        Tolerance stricter = passes;
        step(stricter);
        EXPECT_FALSE(judge(expected, got, stricter).same) << what;
    };
    const double pixel = 1. / (static_cast<double>(expected.width) * expected.height);
    expectStepFails(passes.largest > stated.largest, "max", [](Tolerance& t) { t.largest -= 1; });
    expectStepFails(passes.fraction > stated.fraction, "fraction",
                    [&](Tolerance& t) { t.fraction -= pixel; });
    expectStepFails(passes.cluster > stated.cluster, "cluster", [](Tolerance& t) { --t.cluster; });
    expectStepFails(passes.line > stated.line, "line", [](Tolerance& t) { --t.line; });
    expectStepFails(passes.bias > stated.bias, "bias", [](Tolerance& t) { t.bias -= .01; });
    expectStepFails(passes.flip.value_or(0) > stated.flip.value_or(0), "flip",
                    [](Tolerance& t) { *t.flip -= 1e-4; });
    expectStepFails(passes.relative > stated.relative, "relative",
                    [](Tolerance& t) { t.absolute /= 2.5, t.relative /= 2.5; });
    EXPECT_GT(raised, 0);
}

TEST(NearestTolerance, JustPassesDifferencesOfManyKinds) {
    const Image expected = noise();
    const auto everywhere = [](int, int) { return true; };
    const std::function<bool(int, int)> places[] = {
        everywhere,
        [](int x, int y) { return x > 20 && x < 26 && y == 30; },
        [](int x, int y) { return x >= 40 && x < 46 && y >= 40 && y < 46; },
        [](int x, int y) { return x % 2 == 0 && y == 17; },
        [](int x, int y) { return (7 * x + 13 * y) % 120 == 0; },
    };
    for (unsigned seed = 1; seed < 6; ++seed)
        for (const int most : {4, 6, 9, 40, 200})
            for (std::size_t i = 0; i < std::size(places); ++i) {
                if (i == 0 && most > 16) continue;  // no tolerance is sensible there
                SCOPED_TRACE(::testing::Message()
                             << "place " << i << ", up to " << most << ", seed " << seed);
                const Image got = changed(expected, most, seed, places[i]);
                for (const Tolerance& stated : {Tolerance(), exactTolerance()})
                    if (!judge(expected, got, stated).same) expectJustPasses(expected, got, stated);
            }
}

TEST(NearestTolerance, KeepsTheLimitThatFitsTheDifference) {
    const Image expected = noise();
    const Image shifted = changed(expected, 5, 3, [](int, int) { return true; });
    const NearestTolerance ofNoise =
        nearestTolerance(expected, shifted, {}, judge(expected, shifted, {}, true));
    ASSERT_TRUE(ofNoise.tolerance);
    EXPECT_GE(ofNoise.tolerance->largest, 4);
    EXPECT_EQ(ofNoise.tolerance->cluster, Tolerance().cluster) << "noise everywhere is no group";
    const Image spot = changed(expected, 120, 3, [](int x, int y) { return x / 5 == 4 && y / 5 == 4; });
    const NearestTolerance ofSpot = nearestTolerance(expected, spot, {}, judge(expected, spot, {}, true));
    ASSERT_TRUE(ofSpot.tolerance);
    EXPECT_EQ(ofSpot.tolerance->largest, Tolerance().largest) << "one group does not blind the rest";
    EXPECT_GT(ofSpot.tolerance->cluster, Tolerance().cluster);
}

TEST(NearestTolerance, SaysWhyThereIsNone) {
    const Image expected = noise();
    const auto why = [&](const Image& got) {
        const NearestTolerance nearest = nearestTolerance(expected, got, {}, judge(expected, got, {}, true));
        EXPECT_FALSE(nearest.tolerance);
        return nearest.whyNone;
    };
    EXPECT_NE(why(changed(expected, 200, 1, [](int, int) { return true; })).find("% of the pixels differ"),
              std::string::npos);
    EXPECT_NE(why(changed(expected, 200, 1, [](int x, int y) { return x < 19 && y < 4; })).find("touch"),
              std::string::npos);
    EXPECT_EQ(why(testing::noisyImage(9, 7, 3, Component::u8)), "the sizes differ");
    Image lighter = expected;
    for (std::byte& each : lighter.data)
        each = static_cast<std::byte>(std::min(255, std::to_integer<int>(each) + 6));
    EXPECT_NE(why(lighter).find("lighter or darker"), std::string::npos);
}

TEST(NearestTolerance, OfFloatsIsAShareOfTheValue) {
    Image expected = testing::noisyImage(32, 32, 3, Component::f32), got = expected;
    const auto set = [](Image& image, float factor) {
        for (std::size_t i = 0; i < image.data.size() / sizeof(float); ++i) {
            const float value = (1 + static_cast<float>(i % 97)) * (i % 3 == 0 ? factor : 1);
            std::memcpy(image.data.data() + i * sizeof(float), &value, sizeof value);
        }
    };
    set(expected, 1);
    set(got, 1.0013F);
    expectJustPasses(expected, got, {});
    const NearestTolerance nearest = nearestTolerance(expected, got, {}, judge(expected, got, {}, true));
    EXPECT_EQ(nearest.tolerance->relative, 2e-3) << "exactly, so that its text is short";
    EXPECT_EQ(nearest.tolerance->absolute, 2e-5);
    set(got, 1.2F);
    EXPECT_FALSE(nearestTolerance(expected, got, {}, judge(expected, got, {}, true)).tolerance);
    const float bad = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(got.data.data(), &bad, sizeof bad);
    EXPECT_NE(nearestTolerance(expected, got, {}, judge(expected, got, {}, true)).whyNone.find("NaN"),
              std::string::npos);
}

TEST(NearestTolerance, RaisesAPerceptualLimitThatIsStated) {
    const Image expected = noise();
    const Image got =
        changed(expected, 60, 1, [](int x, int y) { return x > 60 && x < 72 && y > 20 && y < 32; });
    Tolerance stated;
    stated.flip = 1e-4;
    expectJustPasses(expected, got, stated);
    EXPECT_GT(*nearestTolerance(expected, got, stated, judge(expected, got, stated, true)).tolerance->flip,
              1e-4);
}

TEST(NearestTolerance, LeavesAPerceptualLimitWhereAnotherCostsLess) {
    const Image expected = noise();
    const Image got = changed(expected, 6, 1, [](int, int) { return true; });
    Tolerance stated;
    stated.flip = 1e-4;
    stated.bias = 3;
    const auto nearest = nearestTolerance(expected, got, stated, judge(expected, got, stated, true));
    ASSERT_TRUE(nearest.tolerance) << nearest.whyNone;
    EXPECT_EQ(nearest.tolerance->flip, 1e-4);
    EXPECT_EQ(nearest.tolerance->largest, 6);
}

TEST(DifferenceSteps, CountPixelsByTheirLargestDifference) {
    const Image expected = noise();
    Image got = expected;
    std::vector<int> wanted(6);
    const int limits[] = {0, 1, 2, 4, 8, 16};
    for (int i = 0; i < 40; ++i) {
        auto& byte = got.data[static_cast<std::size_t>(i) * 30];
        const int value = std::to_integer<int>(byte);
        byte = static_cast<std::byte>(value > 127 ? value - i : value + i);
        for (std::size_t k = 0; k < 6; ++k) wanted[k] += i > limits[k] ? 1 : 0;
    }
    const DifferenceSteps steps = differenceSteps(expected, got);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_EQ(steps.limits[k], limits[k]);
        EXPECT_EQ(steps.pixels[k], static_cast<std::uint64_t>(wanted[k])) << limits[k];
    }
    EXPECT_TRUE(differenceSteps(expected, testing::noisyImage(9, 7, 3, Component::u8)).limits.empty());
}

}  // namespace
}  // namespace glibra::image
