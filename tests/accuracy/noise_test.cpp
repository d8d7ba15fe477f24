#include <gtest/gtest.h>

#include <cmath>

#include "bench/core/figure.h"
#include "bench/reference/filtering.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(NoiseVolume, TexelsHaveTheirValuesAtTheirPlaces) {
    const std::vector<float> exact = exactTexels(8);
    const NoiseVolume volume(8, kNoiseFormats[4], exact);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 place(i / 8., (7 - i) / 8., .125);
        const Octaves found = volume.at(place), wanted = exactNoise(place);
        for (std::size_t octave = 0; octave < found.size(); ++octave)
            EXPECT_NEAR(found[octave], wanted[octave], 1e-7);
    }
    const Octaves here = volume.at({.3, .4, .95}), next = volume.at({1.3, -.6, -.05});
    for (std::size_t octave = 0; octave < here.size(); ++octave)
        EXPECT_NEAR(here[octave], next[octave], 1e-12);
}

TEST(NoiseVolume, TheSequenceFillsEveryEighthOfTheCubeAlike) {
    std::array<int, 8> count{};
    for (int i = 0; i < 800; ++i) {
        const glm::dvec3 place = spread(i);
        ++count[(place.x < .5 ? 0U : 1U) + (place.y < .5 ? 0U : 2U) + (place.z < .5 ? 0U : 4U)];
    }
    for (const int each : count) EXPECT_NEAR(each, 100, 12);
}

using Noise = FiguresOf<measureNoise>;

TEST_F(Noise, InterpolationOfASmoothOctaveIsOfSecondOrder) {
    EXPECT_NEAR(fittedOrder(curve("octaves", "4 cells per period")), -2, .1);
}

TEST_F(Noise, OneTexelPerCellHoldsNothingOfAnOctave) {
    // Every texel is at a lattice point, where the noise is 1/2.
    EXPECT_NEAR(curve("octaves", "16 cells per period").points.front().error, 1, 1e-9);
    EXPECT_NEAR(curve("octaves", "32 cells per period").points[1].error, 1, 1e-9);
}

TEST_F(Noise, RoundingToBytesAddsTheNoiseOfRounding) {
    // Variance 1/12 per texel and octave; four octaves; each axis of the interpolation keeps 2/3 of it.
    const double bytes = curve("texels", "8 bit, rounded").points.back().error;
    const double floats = curve("texels", "float").points.back().error;
    EXPECT_NEAR(std::sqrt(bytes * bytes - floats * floats), std::sqrt(4. / 12 * 8 / 27), .08);
}

TEST_F(Noise, TruncationMakesTheSumDarkerByHalfAStepPerOctave) {
    const double cut = curve("texels", "8 bit, cut off").points.back().error;
    const double rounded = curve("texels", "8 bit, rounded").points.back().error;
    EXPECT_NEAR(std::sqrt(cut * cut - rounded * rounded), 2, .15);
}

TEST_F(Noise, TheFunctionInTheShaderIsTheOneOnTheCpu) {
    EXPECT_LT(curve("drawn", "function in the shader").points.front().error, .01);
}

TEST_F(Noise, TheShadersFilterAndTheDriversAgree) {
    const Curve& driver = curve("drawn", "driver's filter, float");
    const Curve& shader = curve("drawn", "shader's filter, float");
    for (std::size_t i = 0; i < driver.points.size(); ++i)
        EXPECT_NEAR(driver.points[i].error, shader.points[i].error, .05);
}

TEST_F(Noise, BytesFilteredInBytesAreWorse) {
    const Curve* bytes = findCurve(figure("drawn"), "driver's filter in bytes, 8 bit, cut off");
    if (!bytes) GTEST_SKIP() << "this driver has one way of filtering";
    EXPECT_GT(bytes->points.back().error,
              curve("drawn", "driver's filter, 8 bit, cut off").points.back().error);
}

TEST_F(Noise, RepeatingHidesTheSeamAndClampingDoesNot) {
    const double middle = curve("seam", "repeated, in the middle").points.back().error;
    EXPECT_LT(curve("seam", "repeated").points.back().error, 1.3 * middle);
    EXPECT_GT(curve("seam", "clamped to the edge").points.back().error, 1.3 * middle);
}

TEST_F(Noise, TheDriversFilterIsTheOneInDouble) {
    // Other places of the same texture: the mean of many is alike.
    const Curve &drawn = curve("drawn", "driver's filter, float"), &inDouble = curve("texels", "float");
    for (std::size_t i = 0; i < drawn.points.size(); ++i)
        EXPECT_NEAR(drawn.points[i].error / inDouble.points[i].error, 1, .1) << drawn.points[i].label;
}

}  // namespace
}  // namespace glibra::bench::test
