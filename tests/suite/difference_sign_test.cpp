// Which differences of pictures are alike.

#include "suite/serve/review.h"

#include <gtest/gtest.h>

#include "pictures.h"

namespace glibra::suite {
namespace {

/// The gradient with a rectangle from the left edge that is changed by `red`, `green` and `blue`.
image::Image changed(int width, int red, int green, int blue) {
    const int by[] = {red, green, blue};
    return picture(
        32, 32, [&](int x, int y, int c) { return 4 * x + 2 * y + 10 * c + 20 + (x < width ? by[c] : 0); });
}

DifferenceSign signOf(int width, int red, int green, int blue) {
    return *differenceSign(changed(0, 0, 0, 0), changed(width, red, green, blue));
}

TEST(DifferenceSigns, SayHowMuchAndWhichWay) {
    EXPECT_FALSE(differenceSign(gradient(), gradient()));
    EXPECT_FALSE(differenceSign(gradient(), floats(1, 1))) << "another size";
    const DifferenceSign sign = signOf(8, -12, -12, -12);
    EXPECT_EQ(sign.share, .25);
    EXPECT_EQ(sign.size, 12);
    EXPECT_EQ(toText(sign), "12 of 255 darker in 25 % of the pixels");
    EXPECT_EQ(toText(signOf(16, 9, -9, 0)), "6 of 255 other colours in 50 % of the pixels");
}

TEST(DifferenceSigns, AreAlikeInColourSizeAndShare) {
    EXPECT_TRUE(areAlike(signOf(8, 10, 10, 10), signOf(12, 14, 14, 14)));
    EXPECT_FALSE(areAlike(signOf(8, 10, 10, 10), signOf(8, -10, -10, -10))) << "lighter and darker";
    EXPECT_FALSE(areAlike(signOf(8, 10, 10, 10), signOf(8, 20, 0, 0))) << "grey and red";
    EXPECT_FALSE(areAlike(signOf(8, 10, 10, 10), signOf(8, 40, 40, 40))) << "four times as much";
    EXPECT_FALSE(areAlike(signOf(4, 10, 10, 10), signOf(32, 10, 10, 10))) << "eight times as many pixels";
}

}  // namespace
}  // namespace glibra::suite
