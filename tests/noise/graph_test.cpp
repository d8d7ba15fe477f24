#include "noise/noise_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace glibra::noise {
namespace {

constexpr double kStep = 1e-5;

double slopeAt(const GraphOptions& options, double x) {
    return (graphNoise(options, x + kStep) - graphNoise(options, x - kStep)) / (2 * kStep);
}

TEST(GraphNoise, OfGradientsIsZeroAtThePoints) {
    for (const Smoothness smoothness : {Smoothness::cubic, Smoothness::quintic}) {
        GraphOptions options;
        options.lattice = Lattice::gradient;
        options.smoothness = smoothness;
        options.octaves = 4;
        for (int i = 0; i < 8; ++i) EXPECT_EQ(graphNoise(options, i), 0);
        EXPECT_NE(graphNoise(options, 2.3), 0);
    }
}

TEST(GraphNoise, OfValuesPassesThroughThePointsThatAreSet) {
    GraphOptions options;
    options.heights = {{2, .75}, {3, -.5}};
    options.gradients = {{2, 3}};
    EXPECT_EQ(graphNoise(options, 2), .75);
    EXPECT_EQ(graphNoise(options, 3), -.5);
    EXPECT_EQ(graphNoise(options, 10), .75) << "periodic";
    EXPECT_EQ(graphNoise(options, -5), -.5);
    EXPECT_NEAR(slopeAt(options, 2), 3, 1e-4);
    EXPECT_NEAR(slopeAt(options, 3), 0, 1e-4);
}

TEST(GraphNoise, WithCatmullRomHasHalfTheDifferenceOfTheNeighboursAsSlope) {
    GraphOptions options;
    options.slopes = Slopes::catmullRom;
    options.smoothness = Smoothness::cubic;
    for (int i = 1; i < 7; ++i)
        EXPECT_NEAR(slopeAt(options, i), (graphNoise(options, i + 1) - graphNoise(options, i - 1)) / 2, 1e-4);
    // A Catmull-Rom curve through points on a line is that line.
    options.heights = {{0, 0}, {1, .1}, {2, .2}, {3, .3}};
    EXPECT_NEAR(graphNoise(options, 1.37), .137, 1e-12);
}

TEST(GraphNoise, HasCurvatureAtThePointsWithCubicsButNotWithQuintics) {
    const auto curvature = [](Smoothness smoothness) {
        GraphOptions options;
        options.smoothness = smoothness;
        constexpr double kWide = 1e-3;
        return (graphNoise(options, 3 + 2 * kWide) - 2 * graphNoise(options, 3 + kWide) +
                graphNoise(options, 3)) /
               (kWide * kWide);
    };
    EXPECT_LT(std::abs(curvature(Smoothness::quintic)), .2);
    EXPECT_GT(std::abs(curvature(Smoothness::cubic)), .5);
}

TEST(GraphNoise, WithQuinticsHasTheGivenCurvatureAndKeepsHeightsAndGradients) {
    GraphOptions options;
    options.lattice = Lattice::both;
    options.heights = {{3, .25}};
    options.gradients = {{3, -.5}};
    options.curvatures = {{3, 6}};
    constexpr double kWide = 1e-4;
    const double here = graphNoise(options, 3);
    EXPECT_EQ(here, .25);
    EXPECT_NEAR(slopeAt(options, 3), -.5, 1e-4);
    EXPECT_NEAR(
        (graphNoise(options, 3 + kWide) - 2 * here + graphNoise(options, 3 - kWide)) / (kWide * kWide), 6,
        .01);
    // The quintic between two points is c/2 t^2 (1 - t)^3 if only the curvature c of the first is not 0.
    GraphOptions one;
    one.heights = {{0, 0}, {1, 0}};
    one.curvatures = {{0, 10}};
    EXPECT_NEAR(graphNoise(one, .4), 10 / 2. * .4 * .4 * .6 * .6 * .6, 1e-12);
    EXPECT_EQ(graphPoint(options, 3).curvature, 6);
    EXPECT_EQ(graphPoint(options, 2).curvature, 0);
    options.smoothness = Smoothness::cubic;
    GraphOptions without = options;
    without.curvatures.clear();
    EXPECT_EQ(graphNoise(options, 3.3), graphNoise(without, 3.3));
    EXPECT_EQ(graphPoint(options, 3).curvature, 0);
}

TEST(GraphNoise, ReachesItsRangeButNeverExceedsIt) {
    // One period of heights and gradients at their limits.
    GraphOptions options;
    options.cells = 4;
    options.heights = {{0, 1}, {1, 1}, {2, -1}, {3, -1}};
    options.gradients = {{0, 1}, {1, -1}, {2, -1}, {3, 1}};
    const auto highest = [&] {
        double found = 0;
        for (double x = 0; x < 4; x += 1 / 64.) found = std::max(found, std::abs(graphNoise(options, x)));
        return found;
    };
    for (const Smoothness smoothness : {Smoothness::cubic, Smoothness::quintic}) {
        options.smoothness = smoothness;
        options.lattice = Lattice::both;
        EXPECT_DOUBLE_EQ(highest(), graphRange(options));
        GraphOptions natural = options;
        natural.lattice = Lattice::value;
        natural.gradients.clear();
        natural.slopes = Slopes::catmullRom;
        std::swap(natural, options);
        EXPECT_DOUBLE_EQ(highest(), graphRange(options));
        std::swap(natural, options);
    }
}

TEST(GraphNoise, OfOctavesIsTheSumOfHalvedCopies) {
    GraphOptions one;
    one.lattice = Lattice::both;
    GraphOptions three = one;
    three.octaves = 3;
    double highest = 0;
    for (double x = 0; x < 8; x += .01)
        highest = std::max(highest, std::abs(graphNoise(three, x) - graphNoise(one, x)));
    EXPECT_GT(highest, .1);
    EXPECT_LT(highest, .5 * 1.5 + .25 * 1.5);
    three.turbulence = true;
    for (double x = 0; x < 8; x += .1) EXPECT_GE(graphNoise(three, x), 0);
}

TEST(GraphNoise, StaysInsideWhatGraphsShow) {
    for (const Lattice lattice : {Lattice::value, Lattice::gradient, Lattice::both})
        for (std::uint32_t seed = 0; seed < 20; ++seed) {
            GraphOptions options;
            options.lattice = lattice;
            options.seed = seed;
            if (seed % 2 == 1) options.slopes = Slopes::catmullRom;
            options.octaves = 1 + static_cast<int>(seed) % 4;
            double highest = 0;
            for (double x = 0; x < 8; x += .02) highest = std::max(highest, std::abs(graphNoise(options, x)));
            EXPECT_LE(highest, graphRange(options));
            EXPECT_GT(highest, graphRange(options) * .2);
        }
}

TEST(GraphNoise, OfTwoDimensionsIsPeriodicAndContinuous) {
    GraphOptions options;
    options.dimensions = 2;
    options.lattice = Lattice::both;
    options.octaves = 2;
    EXPECT_NEAR(graphNoise(options, 1.3, 2.6), graphNoise(options, 9.3, -5.4), 1e-12);
    EXPECT_NEAR(graphNoise(options, 3 - 1e-9, 2.6), graphNoise(options, 3 + 1e-9, 2.6), 1e-7);
    EXPECT_NEAR(graphNoise(options, 1.3, 4 - 1e-9), graphNoise(options, 1.3, 4 + 1e-9), 1e-7);
}

TEST(GraphNoise, OfOneDimensionIsTheLowerEdgeOfTwo) {
    GraphOptions line;
    line.lattice = Lattice::both;
    line.octaves = 3;
    line.heights = {{1, .5}};
    line.curvatures = {{2, 3}};
    GraphOptions plane = line;
    plane.dimensions = 2;
    for (double x = 0; x < 8; x += .3) EXPECT_NEAR(graphNoise(plane, x, 0), graphNoise(line, x), 1e-12);
    double highest = 0;
    for (double x = 0; x < 8; x += .1)
        for (double y = 0; y < 8; y += .1) highest = std::max(highest, std::abs(graphNoise(plane, x, y)));
    EXPECT_LE(highest, graphRange(plane));
}

TEST(ColorScale, HasTheDocumentedEndsAndTheUniformOneGrowsLighter) {
    EXPECT_EQ(colorOf(ColorScale::grey, .5), (std::array<double, 3>{.5, .5, .5}));
    EXPECT_EQ(colorOf(ColorScale::rainbow, 0), (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(colorOf(ColorScale::rainbow, .5), (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(colorOf(ColorScale::rainbow, 1), (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(colorOf(ColorScale::sky, 0), (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(colorOf(ColorScale::sky, 1), (std::array<double, 3>{1, 1, 1}));
    EXPECT_EQ(colorOf(ColorScale::fire, 0), (std::array<double, 3>{1, 0, 0}));
    EXPECT_EQ(colorOf(ColorScale::fire, 1), (std::array<double, 3>{1, 1, 0}));
    EXPECT_EQ(colorOf(ColorScale::heated, 0), (std::array<double, 3>{0, 0, 0}));
    EXPECT_EQ(colorOf(ColorScale::heated, 1), (std::array<double, 3>{1, 1, 1}));
    // CIE lightness, from luminance, is independent of OKLab, with which the scale is made.
    const auto lightness = [](const std::array<double, 3>& color) {
        const auto linear = [](double c) {
            return c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4);
        };
        const double y = .2126 * linear(color[0]) + .7152 * linear(color[1]) + .0722 * linear(color[2]);
        return 116 * std::cbrt(y) - 16;
    };
    for (int i = 0; i < 20; ++i) {
        const double step = lightness(colorOf(ColorScale::uniform, (i + 1) / 20.)) -
                            lightness(colorOf(ColorScale::uniform, i / 20.));
        EXPECT_GT(step, 2) << i;
        EXPECT_LT(step, 7) << i;
    }
}

TEST(NoiseTexture, IsARawFloatTexture) {
    GraphOptions options;
    options.dimensions = 2;
    const std::vector<std::byte> bytes = noiseTexture(options, 16, 4);
    ASSERT_EQ(bytes.size(), 8U + 16 * 4 * 16);
    EXPECT_EQ(std::to_integer<int>(bytes[0]), 16);
    EXPECT_EQ(std::to_integer<int>(bytes[4]), 4);
    float red = 0;
    std::memcpy(&red, bytes.data() + 8 + 16 * (3 + 16 * 2), sizeof red);
    EXPECT_EQ(red, static_cast<float>(graphNoise(options, 1.5, 4)));
}

TEST(Graph, DrawsTheCurveWhereTheNoiseIs) {
    const GraphOptions options;
    const int width = 160;
    const int height = 80;
    const std::vector<std::uint8_t> pixels = graphPixels(options, width, height);
    for (int x = 5; x < width; x += 20) {
        const double row = (1 - (graphNoise(options, (x + .5) / 20) + 1) / 2) * height;
        const std::size_t at = 3 * static_cast<std::size_t>(static_cast<int>(row) * width + x);
        EXPECT_LT(pixels[at], 100) << x;
    }
    const std::string svg = graphSvg(options, width, height);
    EXPECT_EQ(std::count(svg.begin(), svg.end(), 'L'), 4 * width);
}

}  // namespace
}  // namespace glibra::noise
