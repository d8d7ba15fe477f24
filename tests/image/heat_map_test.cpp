// The picture of differences: its colours and its scale.

#include "image/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support.h"

namespace glibra::image {
namespace {

Image greyRow(const std::vector<int>& values) {
    return {static_cast<int>(values.size()), 1, 1, Component::u8, testing::bytesOf(values)};
}

double lightness(const std::vector<int>& rgb) {
    double y = 0;
    constexpr double kShare[] = {.2126, .7152, .0722};
    for (std::size_t c = 0; c < 3; ++c) {
        const double v = rgb[c] / 255.;
        y += kShare[c] * (v <= .04045 ? v / 12.92 : std::pow((v + .055) / 1.055, 2.4));
    }
    return y > .008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

// Entries of matplotlib's table of magma, lib/matplotlib/_cm_listed.py.
TEST(HeatMap, ColorsAreMagma) {
    constexpr double kTable[][4] = {{0, 0.001462, 0.000466, 0.013866},   {32, 0.113094, 0.065492, 0.276784},
                                    {64, 0.316654, 0.071690, 0.485380},  {96, 0.512831, 0.148179, 0.507648},
                                    {128, 0.716387, 0.214982, 0.475290}, {160, 0.904281, 0.319610, 0.388137},
                                    {192, 0.986700, 0.535582, 0.382210}, {224, 0.996898, 0.769591, 0.534892},
                                    {255, 0.987053, 0.991438, 0.749504}};
    for (const auto& [index, r, g, b] : kTable) {
        double red = 0, green = 0, blue = 0;
        magma(index / 255, red, green, blue);
        EXPECT_NEAR(red, r, .02) << index;
        EXPECT_NEAR(green, g, .02) << index;
        EXPECT_NEAR(blue, b, .02) << index;
    }
}

TEST(HeatMap, EachStepOfALargerDifferenceIsNoDarker) {
    const std::vector<int> zeros(256);
    std::vector<int> all(256);
    for (int i = 0; i < 256; ++i) all[static_cast<std::size_t>(i)] = i;
    const Image map = differenceHeatMap(greyRow(zeros), greyRow(all));
    EXPECT_EQ(testing::pixelAt(map, 0, 0), (std::vector<int>{0, 0, 0}));
    EXPECT_GT(lightness(testing::pixelAt(map, 1, 0)), 5) << "one step can be seen";
    for (int x = 1; x < 256; ++x)
        EXPECT_GE(lightness(testing::pixelAt(map, x, 0)), lightness(testing::pixelAt(map, x - 1, 0)) - .1)
            << x;
    EXPECT_GT(lightness(testing::pixelAt(map, 255, 0)), 95);
}

TEST(HeatMap, TheLargestComponentCounts) {
    const Image a{2, 1, 4, Component::u8, testing::bytesOf({1, 2, 3, 255, 9, 9, 9, 255})};
    const Image b{2, 1, 4, Component::u8, testing::bytesOf({1, 2, 3, 192, 10, 72, 5, 255})};
    const Image map = differenceHeatMap(a, b);
    EXPECT_EQ(map.components, 3);
    EXPECT_EQ(testing::pixelAt(map, 0, 0), testing::pixelAt(map, 1, 0));
}

TEST(HeatMap, NanAndInfinityAreTheLargest) {
    const float values[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            7, 1, 0};
    const Image a{5, 1, 1, Component::f32, std::vector<std::byte>(20)};
    Image b = a;
    std::memcpy(b.data.data(), values, 20);
    const Image map = differenceHeatMap(a, b);
    for (const int x : {0, 1, 2}) EXPECT_EQ(testing::pixelAt(map, x, 0), testing::pixelAt(map, 3, 0)) << x;
    EXPECT_EQ(testing::pixelAt(map, 4, 0), (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(testing::pixelAt(differenceHeatMap(b, b), 0, 0), (std::vector<int>{0, 0, 0}));
}

TEST(HeatMap, OfFlipHasItsErrors) {
    const Image a = testing::noisyImage(20, 10, 3, Component::u8);
    const FlipResult result = flip(a, testing::noisyImage(20, 10, 3, Component::u8, 3));
    const Image map = flipHeatMap(result);
    ASSERT_EQ(map.width, 20);
    double red = 0, green = 0, blue = 0;
    magma(std::round(static_cast<double>(result.errors[47]) * 255) / 255, red, green, blue);
    EXPECT_EQ(testing::pixelAt(map, 7, 2)[1], std::lround(green * 255));
}

TEST(HeatMap, OtherSizesHaveNone) {
    EXPECT_EQ(differenceHeatMap(greyRow({1}), greyRow({1, 2})).data.size(), 0U);
}

}  // namespace
}  // namespace glibra::image
