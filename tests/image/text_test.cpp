#include "image/text.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>

namespace glibra::test {
namespace {

image::Image greyPicture(int width, int height, int components = 3) {
    image::Image picture{width, height, components, image::Component::u8, {}};
    picture.data.assign(picture.rowBytes() * static_cast<std::size_t>(height), std::byte{100});
    return picture;
}

/// '#' white, '.' black, ' ' untouched.
char at(const image::Image& picture, int x, int y) {
    const auto row = picture.row(y);
    const int value = std::to_integer<int>(row[static_cast<std::size_t>(x * picture.components)]);
    return value == 255 ? '#' : value == 0 ? '.' : ' ';
}

std::string rows(const image::Image& picture) {
    std::string text;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) text += at(picture, x, y);
        text += '\n';
    }
    return text;
}

TEST(Text, ALetterIsWhiteWithABlackOutline) {
    image::Image picture = greyPicture(10, 16);
    image::drawText(picture, 1, 0, "T", 1);
    EXPECT_EQ(rows(picture),
              "          \n"
              "          \n"
              "......... \n"
              ".#######. \n"
              "....#.... \n"
              "   .#.    \n"
              "   .#.    \n"
              "   .#.    \n"
              "   .#.    \n"
              "   .#.    \n"
              "   .#.    \n"
              "   .#.    \n"
              "   ...    \n"
              "          \n"
              "          \n"
              "          \n");
}

TEST(Text, EachCharacterLooksDifferent) {
    std::set<std::string> seen;
    for (char c = ' '; c <= '~'; ++c) {
        image::Image picture = greyPicture(10, 18);
        image::drawText(picture, 1, 1, std::string(1, c), 1);
        EXPECT_TRUE(seen.insert(rows(picture)).second) << c;
    }
    EXPECT_EQ(seen.size(), 95U);
}

TEST(Text, ScaledTextIsTheSameInLargerPixels) {
    image::Image small = greyPicture(40, 20);
    image::Image large = greyPicture(120, 60);
    image::drawText(small, 2, 2, "uKd", 1);
    image::drawText(large, 6, 6, "uKd", 3);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) ASSERT_EQ(at(large, x, y), at(small, x / 3, y / 3)) << x << y;
}

TEST(Text, TheOutlineOfALetterDoesNotCoverTheOneBefore) {
    image::Image both = greyPicture(40, 16), first = greyPicture(40, 16);
    image::drawText(both, 2, 0, "MW", 1);
    image::drawText(first, 2, 0, "M", 1);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 10; ++x) {
            if (at(first, x, y) != '#') continue;
            EXPECT_EQ(at(both, x, y), '#') << x << " " << y;
        }
}

TEST(Text, WhatIsOutsideIsCutOffAndOtherAlphabetsAreQuestionMarks) {
    image::Image picture = greyPicture(12, 9);
    image::drawText(picture, -3, -5, "wide text \xC3\xBC", 2);
    image::Image one = greyPicture(30, 16), two = greyPicture(30, 16);
    image::drawText(one, 1, 0, "\xC3\xBC=", 1);
    image::drawText(two, 1, 0, "?=", 1);
    EXPECT_EQ(rows(one), rows(two));
}

TEST(Text, AlphaBecomesOpaqueAndFloatsAreOneOrZero) {
    image::Image picture{20, 16, 4, image::Component::f32, {}};
    picture.data.resize(picture.rowBytes() * 16);
    image::drawText(picture, 1, 0, "T", 1);
    int drawn = 0;
    for (std::size_t i = 0; i < picture.data.size(); i += 16) {
        std::array<float, 4> pixel{};
        std::memcpy(pixel.data(), picture.data.data() + i, sizeof pixel);
        if (pixel[3] == 0) continue;
        ++drawn;
        EXPECT_EQ(pixel[3], 1.F);
        EXPECT_TRUE(pixel[0] == 0.F || pixel[0] == 1.F);
    }
    EXPECT_GT(drawn, 15);
}

}  // namespace
}  // namespace glibra::test
