#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/core/bench.h"
#include "bench/subjects/filters.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

TEST(GaussianWeights, AddUpToOneAndFallAsTheBellDoes) {
    for (const int radius : {1, 2, 5, 16}) {
        const std::vector<double> weights = gaussianWeights(radius);
        ASSERT_EQ(weights.size(), static_cast<std::size_t>(radius) + 1);
        double sum = weights[0];
        for (int i = 1; i <= radius; ++i) {
            sum += 2 * weights[static_cast<std::size_t>(i)];
            const double sigma = radius / 2.;
            EXPECT_NEAR(weights[static_cast<std::size_t>(i)] / weights[0],
                        std::exp(-i * i / (2 * sigma * sigma)), 1e-12);
        }
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

TEST(BlurInDouble, SpreadsOnePixelByTheProductOfTheWeights) {
    Plane plane{9, 9, std::vector<double>(81, 0)};
    plane.values[4 * 9 + 4] = 1;
    const std::vector<double> weights = gaussianWeights(3);
    const Plane spread = blurred(plane, weights);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) {
            const int dx = std::abs(x - 4), dy = std::abs(y - 4);
            const double wanted = dx > 3 || dy > 3 ? 0
                                                   : weights[static_cast<std::size_t>(dx)] *
                                                         weights[static_cast<std::size_t>(dy)];
            EXPECT_NEAR(spread.at(x, y), wanted, 1e-15);
        }
}

TEST(BlurInDouble, LeavesAConstantAlsoAtTheRim) {
    const Plane plane{6, 5, std::vector<double>(30, .3)};
    for (const double value : blurred(plane, gaussianWeights(8)).values) EXPECT_NEAR(value, .3, 1e-12);
}

TEST(SobelInDouble, OfARampIsEightTimesItsSlope) {
    Plane plane{8, 8, {}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) plane.values.push_back(.03 * x + .04 * y);
    const Plane gradient = sobel(plane);
    for (int y = 1; y < 7; ++y)
        for (int x = 1; x < 7; ++x) EXPECT_NEAR(gradient.at(x, y), 8 * .05, 1e-12);
}

class FiltersOnTheDevice : public testing::Test {
  protected:
    /// The largest difference of any pixel from the plane, in 255ths.
    double largest(const Passes& passes, gpu::TexelFormat between, const Plane& wanted) {
        const FilterChain chain(bench, picture, passes, between);
        chain.draw();
        const Plane got = chain.result();
        double most = 0;
        for (std::size_t i = 0; i < wanted.values.size(); ++i)
            most = std::max(most, std::abs(got.values[i] - wanted.values[i]) * 255);
        return most;
    }
    Bench bench{{.quick = true}};
    Plane picture = testPicture(64);
};

TEST_F(FiltersOnTheDevice, OfFloatsAreTheReferenceAtEveryPixel) {
    for (const int radius : {1, 3, 8}) {
        const std::vector<double> weights = gaussianWeights(radius);
        const Plane wanted = blurred(picture, weights);
        const auto format = gpu::TexelFormat::rgba32f;
        EXPECT_LT(largest(directBlur(weights), format, wanted), .001);
        EXPECT_LT(largest(separableBlur(weights), format, wanted), .001);
        // Hardware filters may round weights to 256ths.
        EXPECT_LT(largest(pairedBlur(weights), format, wanted), 2);
    }
    const Plane gradient = sobel(picture);
    EXPECT_LT(largest(directSobel(), gpu::TexelFormat::rgba32f, gradient), .001);
    EXPECT_LT(largest(separableSobel(1, 0), gpu::TexelFormat::rgba32f, gradient), .001);
    EXPECT_LT(largest(separableSobel(.2, .2), gpu::TexelFormat::rgba32f, gradient), .001);
}

TEST_F(FiltersOnTheDevice, OfOneDirectionAreNotABlur) {
    const std::vector<double> weights = gaussianWeights(3);
    EXPECT_GT(largest({separableBlur(weights).front()}, gpu::TexelFormat::rgba32f, blurred(picture, weights)),
              5);
}

TEST_F(FiltersOnTheDevice, RoundToBytesBetweenTheirPasses) {
    // Less than a step for the pixel of each row (half of one where the driver rounds to nearest), averaged
    // by the second pass; and more than the error of floats.
    const std::vector<double> weights = gaussianWeights(4);
    const double most = largest(separableBlur(weights), gpu::TexelFormat::rgba8, blurred(picture, weights));
    EXPECT_LT(most, 1);
    EXPECT_GT(most, .05);
}

TEST(MeasuredFilters, RankTheTexelsByTheirBits) {
    Bench bench({.quick = true});
    const std::vector<Figure> figures = measureFilters(bench);
    ASSERT_EQ(figures.size(), 3U);
    for (const Figure& figure : figures) {
        const std::size_t first = figure.name == "repeated" ? 0 : 1;  // after the direct one
        const auto errorOf = [&](std::size_t i) { return figure.curves[first + i].points.front().error; };
        EXPECT_LT(errorOf(0), errorOf(2)) << "float, 16 bit: " << figure.name;
        EXPECT_LT(errorOf(2), errorOf(1)) << "16 bit, half float: " << figure.name;
        EXPECT_LT(errorOf(1), errorOf(3)) << "half float, 8 bit: " << figure.name;
    }
}

}  // namespace
}  // namespace glibra::bench
