// The measured shift of contours, on pictures that are shifted by a known part of a pixel.

#include "budget/contour_shift.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace glibra::budget {
namespace {

constexpr int kSampledSide = 128;

/// The grey values of a function, averaged over 8 x 8 places per pixel.
image::Image sampledPicture(const std::function<double(double x, double y)>& value) {
    constexpr int kPlaces = 8;
    std::vector<float> values;
    for (int y = 0; y < kSampledSide; ++y)
        for (int x = 0; x < kSampledSide; ++x) {
            double sum = 0;
            for (int i = 0; i < kPlaces * kPlaces; ++i)
                sum += value(x + (i % kPlaces + .5) / kPlaces, y + (i / kPlaces + .5) / kPlaces);
            for (int component = 0; component < 3; ++component)
                values.push_back(static_cast<float>(sum / (kPlaces * kPlaces)));
        }
    image::Image made{kSampledSide, kSampledSide, 3, image::Component::f32, {}};
    made.data.resize(values.size() * sizeof(float));
    std::memcpy(made.data.data(), values.data(), made.data.size());
    return made;
}

double contourShift(const image::Image& from, const image::Image& to, double change = 0) {
    return ContourShifts(from, to).ofChangesAbove(change);
}

double wave(double x, double y) {
    return .5 + .4 * std::sin(.12 * x + .09 * y);
}

TEST(ContourShift, FindsThePartOfAPixelByWhichAWaveMoved) {
    // Along the gradient, whose direction is (4, 3) / 5.
    const image::Image before = sampledPicture(wave);
    for (const double shift : {.1, .5, 1.5}) {
        const image::Image after =
            sampledPicture([&](double x, double y) { return wave(x - .8 * shift, y - .6 * shift); });
        EXPECT_NEAR(contourShift(before, after), shift, .1 * shift) << shift;
    }
}

TEST(ContourShift, DoesNotDependOnTheContrast) {
    const auto faint = [](double x, double y) { return .5 + (wave(x, y) - .5) / 4; };
    const double full = contourShift(sampledPicture(wave),
                                     sampledPicture([](double x, double y) { return wave(x - .8, y - .6); }));
    EXPECT_NEAR(contourShift(sampledPicture(faint),
                             sampledPicture([&](double x, double y) { return faint(x - .8, y - .6); })),
                full, .02);
}

TEST(ContourShift, FindsItForSharpEdges) {
    const auto edges = [](double x, double y) { return std::sin(.12 * x + .09 * y) > 0 ? .9 : .1; };
    for (const double shift : {.3, .8}) {
        const double found = contourShift(sampledPicture(edges), sampledPicture([&](double x, double y) {
                                              return edges(x - .8 * shift, y - .6 * shift);
                                          }));
        EXPECT_GT(found, .75 * shift);
        EXPECT_LT(found, 1.5 * shift);
    }
}

TEST(ContourShift, IsZeroWhereNoChangeIsLargeEnough) {
    const image::Image before = sampledPicture(wave);
    EXPECT_EQ(contourShift(before, before), 0);
    const image::Image after = sampledPicture([](double x, double y) { return wave(x, y) + .007; });
    EXPECT_EQ(contourShift(before, after, .0071), 0);
    EXPECT_GT(contourShift(before, after, .0069), 0);
}

TEST(ContourShift, CountsInTheUnitsAsked) {
    const image::Image before = sampledPicture(wave),
                       after = sampledPicture([](double x, double y) { return wave(x - 1, y); });
    EXPECT_DOUBLE_EQ(ContourShifts(before, after, 3).ofChangesAbove(0), 3 * contourShift(before, after));
}

TEST(ContourShift, NoticesAChangeInOneCorner) {
    const image::Image before = sampledPicture(wave);
    const image::Image after =
        sampledPicture([](double x, double y) { return wave(x - (x < 40 && y < 40 ? 1. : 0.), y); });
    EXPECT_GT(contourShift(before, after), .5);
}

TEST(ContourShift, CountsLightOfAnotherColourButNoEdges) {
    const auto lit = [](double more) {
        return sampledPicture([=](double x, double y) { return (x < 64 ? .2 : .9) + (y < 32 ? more : 0); });
    };
    // A quarter of the pixels, except those next to the edge and to the border of the light.
    const auto share = [&](double more, double above, double shift = 0) {
        return ContourShifts(lit(0), lit(more)).shareOfSmoothChangesAbove(above, shift);
    };
    EXPECT_NEAR(share(.05, .04), .25, .01);
    EXPECT_EQ(share(.05, .06), 0);
    const auto moved = sampledPicture([](double x, double) { return x < 64.5 ? .2 : .9; });
    EXPECT_EQ(ContourShifts(lit(0), moved).shareOfSmoothChangesAbove(.01, 0), 0);
}

TEST(ContourShift, DoesNotCountWhatAShiftChanges) {
    const image::Image before = sampledPicture(wave),
                       after = sampledPicture([](double x, double y) { return wave(x - .4, y - .3); });
    EXPECT_GT(ContourShifts(before, after).shareOfSmoothChangesAbove(.005, 0), .5);
    EXPECT_LT(ContourShifts(before, after).shareOfSmoothChangesAbove(.005, .5), .01);
    EXPECT_LT(ContourShifts(before, after, 2).shareOfSmoothChangesAbove(.005, 1), .01);
}

TEST(ContourShift, ReadsBytesAsFloats) {
    const auto asBytes = [](const image::Image& floats) {
        image::Image bytes{floats.width, floats.height, 3, image::Component::u8, {}};
        for (std::size_t i = 0; i < floats.data.size(); i += sizeof(float)) {
            float value = 0;
            std::memcpy(&value, floats.data.data() + i, sizeof(float));
            bytes.data.push_back(static_cast<std::byte>(std::lround(255 * value)));
        }
        return bytes;
    };
    const image::Image before = sampledPicture(wave),
                       after = sampledPicture([](double x, double y) { return wave(x - .8, y - .6); });
    EXPECT_NEAR(contourShift(asBytes(before), asBytes(after)), contourShift(before, after), .05);
}

TEST(ContourShift, TakesNanAsBlack) {
    const image::Image before = sampledPicture([](double, double) { return 0.; });
    image::Image after = before;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(after.data.data(), &nan, sizeof(nan));
    EXPECT_EQ(contourShift(before, after), 0);
}

}  // namespace
}  // namespace glibra::budget
