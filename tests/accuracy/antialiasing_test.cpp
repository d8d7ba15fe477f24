#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "bench/core/figure.h"
#include "bench/reference/filtering.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(Coverage, ATriangleThatCoversHalfASquareOfPixelsHasHalfItsArea) {
    const std::vector<FlatTriangle> triangles{{{{0, 0}, {4, 0}, {0, 4}}}};
    const std::vector<double> shares = coverage(triangles, 4, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_DOUBLE_EQ(shares[static_cast<std::size_t>(y * 4 + x)], x + y < 3    ? 1
                                                                          : x + y == 3 ? .5
                                                                                       : 0);
}

TEST(Coverage, AreasOfAnyTriangleAddUpAndReachBeyondThePictureWithoutHarm) {
    const std::vector<FlatTriangle> inside{{{{1.3, .7}, {8.9, 5.1}, {2.2, 9.6}}}};
    const std::vector<double> shares = coverage(inside, 10, 10);
    const double area = .5 * std::abs((8.9 - 1.3) * (9.6 - .7) - (2.2 - 1.3) * (5.1 - .7));
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.), area, 1e-12);
    const std::vector<FlatTriangle> beyond{{{{-100, -100}, {200, -100}, {-100, 200}}}};
    const std::vector<double> full = coverage(beyond, 3, 3);
    EXPECT_DOUBLE_EQ(std::accumulate(full.begin(), full.end(), 0.), 9);
}

TEST(PixelFilter, EveryFilterKeepsAConstantAndItsWeightsMatchItsDefinition) {
    const std::vector<float> constant(40 * 40, .625F);
    for (const PixelFilter& filter : kPixelFilters) {
        for (const double each : reduce(constant, 10, 10, 4, filter)) EXPECT_NEAR(each, .625, 1e-14);
        EXPECT_GT(filter.weight(0), 0);
        EXPECT_EQ(filter.weight(filter.radius + .001), 0);
    }
    const PixelFilter &mitchell = kPixelFilters[3], &lanczos = kPixelFilters[4];
    EXPECT_NEAR(mitchell.weight(0), 8. / 9, 1e-15);
    EXPECT_NEAR(mitchell.weight(1), 1. / 18, 1e-15);
    EXPECT_NEAR(lanczos.weight(1), 0, 1e-15);
    EXPECT_NEAR(lanczos.weight(1.5), -.06355, 5e-4);
}

TEST(PixelFilter, BoxIsTheMeanOfAPixelsSamplesAndTentReachesTheNeighbours) {
    std::vector<float> samples(6 * 6, 0.F);
    samples[2 * 6 + 2] = 1;  // upper left sample of the middle pixel
    const std::vector<double> box = reduce(samples, 3, 3, 2);
    EXPECT_DOUBLE_EQ(box[4], .25);
    EXPECT_DOUBLE_EQ(box[0], 0);
    const std::vector<double> tent = reduce(samples, 3, 3, 2, kPixelFilters[1]);
    EXPECT_GT(tent[0], tent[8]);
    // Weights of the middle pixel along one axis: .25 .75 .75 .25 for samples 1 to 4.
    EXPECT_DOUBLE_EQ(tent[4], .375 * .375);
}

using Antialiasing = FiguresOf<measureAntialiasing>;

TEST_F(Antialiasing, ErrorOnEdgesFallsAsTheGridsDistanceTimesItsRoot) {
    // The error of the area of an edge on a regular grid of n x n samples is between 1/n (parallel) and
    // n^-1.5 (any slope), which is an order of -.5 to -.75 in samples; Mitchell, Consequences of Stratified
    // Sampling in Graphics, 1996.
    const double order = fittedOrder(curve("edges", "supersampling, box"));
    EXPECT_LT(order, -.6);
    EXPECT_GT(order, -1);
}

TEST_F(Antialiasing, MultisamplingHelpsEdgesAndNothingElse) {
    Bench bench({.quick = true});
    const bool isSoftware = bench.capabilities().isSoftware;
    for (const Figure& each : figures) {
        const Curve& multi = each.curves.front();
        if (multi.points.size() < 2) GTEST_SKIP() << "this driver has one sample only";
        const double left = multi.points.back().error / multi.points.front().error;
        if (each.name == "edges") {
            EXPECT_LT(left, .6);
        } else {
            // OpenGL allows more than one run of the shader per pixel (4.6, 14.3.1); NVIDIA's driver does
            // that.
            EXPECT_LT(left, 1.02) << each.name;
            if (isSoftware) {
                EXPECT_GT(left, .98) << each.name;
            }
        }
    }
}

TEST_F(Antialiasing, EveryFilterGetsCloserToItsLimitWithMoreSamples) {
    for (const Figure& each : figures)
        for (const Curve& found : each.curves)
            if (found.name.find("supersampling") != std::string::npos) {
                EXPECT_LT(fittedOrder(found), -.3) << each.name << ": " << found.name;
            }
}

TEST_F(Antialiasing, OneSampleOfAnIntegratedStripeBeatsSixteenOfAStep) {
    const double steps = curve("stripes", "step, supersampling, box").points.back().error;
    EXPECT_LT(curve("stripes", "integral along the gradient, supersampling, box").points.front().error,
              steps);
    EXPECT_LT(curve("stripes", "integral over the pixel, supersampling, box").points.front().error, 1.5);
}

TEST_F(Antialiasing, ManySamplesAgreeWithTheExactIntegrals) {
    for (const char* name : {"edges", "checkerboard"}) {
        const std::string& finding = figure(name).findings.front();
        const std::string words = "32 x 32 samples are within ";
        ASSERT_TRUE(finding.starts_with(words)) << finding;
        EXPECT_LT(std::stod(finding.substr(words.size())), 2.) << name;
    }
}

}  // namespace
}  // namespace glibra::bench::test
