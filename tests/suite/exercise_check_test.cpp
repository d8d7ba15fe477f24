// Whether a picture solves an exercise.

#include "suite/run/exercise_check.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace glibra::suite::test {
namespace {

constexpr int kSide = 100;

/// A grey picture with the left upper corner of `width` x `height` pixels in another grey.
image::Image picture(int width = 0, int height = 0, int grey = 200) {
    image::Image made{kSide, kSide, 3, image::Component::u8, {}};
    made.data.assign(std::size_t{kSide} * kSide * 3, std::byte{100});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 3 * width; ++x)
            made.data[static_cast<std::size_t>(y * 3 * kSide + x)] = static_cast<std::byte>(grey);
    return made;
}

TEST(WhyUnsolved, RoundingIsNoDifferenceAndAShapeIs) {
    EXPECT_EQ(whyUnsolved({}, picture(), picture()), "");
    EXPECT_EQ(whyUnsolved({}, picture(), picture(3, 3)), "") << "a few pixels of an edge";
    EXPECT_EQ(whyUnsolved({}, picture(), picture(10, 2, 104)), "");
    EXPECT_EQ(whyUnsolved({}, picture(), picture(50, 2)),
              "its picture differs from the solution's in 1 % of the pixels, most at 0, 0");
    EXPECT_EQ(whyUnsolved({}, picture(), picture(kSide, kSide, 103)),
              "its picture is lighter or darker than the solution's around 0, 0");
    image::Image small = picture();
    small.height = 50;
    small.data.resize(small.data.size() / 2);
    EXPECT_EQ(whyUnsolved({}, picture(), small), "its picture has 100 x 50 pixels, the solution's 100 x 100");
}

TEST(WhyUnsolved, WhatAPictureMustHaveCountsInPlaceOfTheSolution) {
    const ColorShare share{{.8, .8, .8}, .05, .01, .2};
    EXPECT_EQ(whyUnsolved(share, picture(), picture(50, 2)), "");
    EXPECT_EQ(whyUnsolved(share, picture(), picture()),
              "less than 0.1 % of its picture has the colour 0.8 0.8 0.8, expected 1 to 20 %");
    EXPECT_EQ(whyUnsolved(share, picture(), picture(50, 50)),
              "25 % of its picture has the colour 0.8 0.8 0.8, expected 1 to 20 %");
}

}  // namespace
}  // namespace glibra::suite::test
