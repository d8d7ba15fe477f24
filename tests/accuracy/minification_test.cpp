#include <gtest/gtest.h>

#include <numeric>

#include "bench/core/figure.h"
#include "bench/reference/filtering.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(TestCard, LevelsKeepTheMeanAndEndInOneTexel) {
    std::vector<std::uint8_t> texels = testCard();
    const double mean =
        std::accumulate(texels.begin(), texels.end(), 0.) / static_cast<double>(texels.size());
    for (int side = kCardSide; side > 1; side /= 2) texels = halved(texels, side);
    ASSERT_EQ(texels.size(), 1U);
    EXPECT_NEAR(texels.front(), mean, 3);
}

TEST(TestCard, BilinearIsTheTexelAtItsCentreAndTheMeanBetweenFour) {
    const std::vector<std::uint8_t> texels{10, 20, 30, 40};
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {.5, .5}), 10. / 255);
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {1.5, .5}), 20. / 255);
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {.5, 1.5}), 30. / 255);
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {1, 1}), 25. / 255);
    // Half way between the last texel and the first one of the next period.
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {2, .5}), 15. / 255);
    EXPECT_DOUBLE_EQ(bilinear(texels, 2, {-.5, .5}), 20. / 255);
}

class Minification : public FiguresOf<measureMinification> {
  protected:
    static double error(std::string_view in, std::string_view name) {
        return curve(in, name).points.back().error;
    }
};

TEST_F(Minification, EachFilterOfThePlaneIsBetterThanTheCheaperOne) {
    EXPECT_LT(error("plane", "linear"), .8 * error("plane", "nearest"));
    EXPECT_LT(error("plane", "mipmaps, bilinear"), .8 * error("plane", "linear"));
    EXPECT_LT(error("plane", "mipmaps, trilinear"), error("plane", "mipmaps, bilinear"));
    if (findCurve(figure("plane"), "anisotropic")) {
        EXPECT_LT(error("plane", "anisotropic"), .8 * error("plane", "mipmaps, trilinear"));
    }
}

TEST_F(Minification, SupersamplingComesCloseToTheReferenceAtFirstOrderOrBetter) {
    for (const char* name : {"supersampling, linear", "supersampling, trilinear"}) {
        // The setting is the number of texels, which grows with the square of the samples along an axis.
        EXPECT_LT(fittedOrder(curve("plane", name)), -.5) << name;
        EXPECT_LT(error("plane", name), 4) << name;
    }
}

TEST_F(Minification, TheFilterOfTheDriverIsThatOfDouble) {
    // Hardware stores 8 bits of the weights: half a step for each of two axes.
    EXPECT_LT(curve("arithmetic", "the driver as glibra sets it up").points.front().error, 1.1);
}

TEST_F(Minification, BytesFilteredInBytesAreAStepOff) {
    const Curve* bytes = findCurve(figure("arithmetic"), "filtered in bytes");
    if (!bytes) GTEST_SKIP() << "this driver has one way of filtering";
    for (const Point& point : bytes->points) {
        EXPECT_GT(point.error, .3) << point.label;
        EXPECT_LT(point.error, 2.5) << point.label;
    }
    EXPECT_LT(error("arithmetic", "the driver as glibra sets it up"), .01);
}

TEST_F(Minification, FromTheFrontLinearIsRightAtOneTexelPerPixelAndMipmapsBeyond) {
    EXPECT_LT(curve("front", "linear").points.front().error, 5);
    EXPECT_GT(error("front", "linear"), 3 * error("front", "mipmaps, bilinear"));
    EXPECT_GT(error("front", "nearest"), error("front", "linear"));
}

}  // namespace
}  // namespace glibra::bench::test
