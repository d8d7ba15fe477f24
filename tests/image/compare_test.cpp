// Measures of difference, checks of single pictures, and conversions: against numbers computed by hand.

#include "image/compare/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/image.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::floatImage;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(CompareImages, EqualPicturesAreIdentical) {
    for (const Component type : {Component::u8, Component::u16, Component::f32}) {
        const Image image = testing::noisyImage(9, 7, 3, type);
        const Comparison result = compare(image, image);
        EXPECT_TRUE(result.identical);
        EXPECT_EQ(result.differingPixels, 0U);
        EXPECT_EQ(result.largest, 0);
        EXPECT_EQ(result.rootMeanSquare, 0);
    }
}

TEST(CompareImages, FindsNumberPlaceAndSizeOfDifferences) {
    const Image a = testing::noisyImage(5, 4, 3, Component::u8);
    Image b = a;
    const auto set = [&](std::size_t x, std::size_t y, std::size_t c, int by) {
        auto& byte = b.data[(y * 5 + x) * 3 + c];
        const int value = std::to_integer<int>(byte);
        byte = static_cast<std::byte>(value >= by ? value - by : value + by);
    };
    set(1, 0, 0, 3);
    set(4, 2, 1, 4);
    set(4, 2, 2, 1);
    const Comparison result = compare(a, b);
    EXPECT_FALSE(result.identical);
    EXPECT_EQ(result.differingPixels, 2U);
    EXPECT_DOUBLE_EQ(result.largest, 4. / 255);
    EXPECT_EQ(result.x, 4);
    EXPECT_EQ(result.y, 2);
    EXPECT_EQ(result.component, 1);
    EXPECT_DOUBLE_EQ(result.rootMeanSquare, std::sqrt((9. + 16 + 1) / 60) / 255);
    const Comparison other = compare(b, a);
    EXPECT_EQ(other.largest, result.largest);
    EXPECT_EQ(other.rootMeanSquare, result.rootMeanSquare);
}

TEST(CompareImages, AnotherSizeIsAResultNotACrash) {
    const Comparison result =
        compare(testing::noisyImage(5, 4, 3, Component::u8), testing::noisyImage(4, 5, 3, Component::u8));
    EXPECT_FALSE(result.sameSize);
    EXPECT_FALSE(result.identical);
    EXPECT_EQ(result.differingPixels, 0U);
    EXPECT_FALSE(compare(testing::noisyImage(5, 4, 3, Component::u8), {}).sameSize);
    EXPECT_TRUE(compare({}, {}).identical);
}

TEST(CompareImages, AnOpaqueRgbaPictureEqualsItsRgb) {
    const Image rgb = testing::noisyImage(5, 4, 3, Component::u8);
    Image rgba = withComponents(rgb, 4);
    EXPECT_TRUE(compare(rgb, rgba).identical);
    rgba.data[7] = std::byte{254};
    const Comparison result = compare(rgb, rgba);
    EXPECT_EQ(result.differingPixels, 1U);
    EXPECT_EQ(result.component, 3);
    EXPECT_EQ(result.x, 1);
}

TEST(CompareImages, BytesEqualTheirSixteenBits) {
    const Image bytes = testing::noisyImage(5, 4, 4, Component::u8);
    EXPECT_TRUE(compare(bytes, withType(bytes, Component::u16)).identical);
    EXPECT_TRUE(compare(withType(bytes, Component::f32), bytes).identical);
}

TEST(CompareImages, NanEqualsNanAndNothingElse) {
    const Image a = floatImage(2, 1, 1, {kNan, kInfinity});
    EXPECT_TRUE(compare(a, a).identical);
    EXPECT_TRUE(compare(floatImage(1, 1, 1, {0.F}), floatImage(1, 1, 1, {-0.F})).identical);
    const Comparison result = compare(a, floatImage(2, 1, 1, {0, kInfinity}));
    EXPECT_EQ(result.differingPixels, 1U);
    EXPECT_EQ(result.largest, std::numeric_limits<double>::infinity());
    EXPECT_EQ(result.x, 0);
    const Comparison halves = compare(floatImage(2, 1, 1, {1, 2}), floatImage(2, 1, 1, {1, 2.5F}));
    EXPECT_EQ(halves.largest, .5);
    EXPECT_DOUBLE_EQ(halves.rootMeanSquare, std::sqrt(.125));
}

TEST(CompareImages, FindsWhatAPlainLoopFinds) {
    for (const int width : {1, 3, 67, 5000})
        for (const int components : {1, 3, 4}) {
            const Image a = testing::noisyImage(width, 5, components, Component::u8);
            Image b = a;
            for (std::size_t i = 0; i < b.data.size(); ++i)
                if (testing::hash(static_cast<std::uint32_t>(i)) % 3 == 0) b.data[i] ^= std::byte{0x55};
            int largest = 0;
            std::size_t place = 0, pixels = 0;
            double squares = 0;
            for (std::size_t i = 0; i < b.data.size(); ++i) {
                const int d = std::abs(std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i]));
                if (d > largest) place = i;
                largest = std::max(largest, d);
                squares += d * d;
            }
            const auto step = static_cast<std::size_t>(components);
            for (std::size_t i = 0; i < b.data.size(); i += step)
                pixels += std::memcmp(&a.data[i], &b.data[i], step) != 0 ? 1 : 0;
            const Comparison result = compare(a, b);
            EXPECT_DOUBLE_EQ(result.largest, largest / 255.);
            EXPECT_EQ(result.differingPixels, pixels);
            EXPECT_EQ(static_cast<std::size_t>((result.y * width + result.x) * components + result.component),
                      place);
            EXPECT_DOUBLE_EQ(result.rootMeanSquare,
                             std::sqrt(squares / static_cast<double>(b.data.size())) / 255);
        }
}

TEST(CompareImages, NumbersThatAreNotFiniteAreCountedInEither) {
    const Image a = floatImage(4, 1, 1, {kNan, kInfinity, 1, 1});
    EXPECT_EQ(compare(a, floatImage(4, 1, 1, {kNan, 1, kNan, 1})).nonFinite, 3U);
    EXPECT_EQ(compare(a, a).nonFinite, 2U);
}

TEST(InspectImage, OneColorIsSeenAndOneOddPixelToo) {
    Image image{7, 5, 3, Component::u8, {}};
    for (int i = 0; i < 35; ++i)
        for (const int c : {1, 2, 3}) image.data.push_back(static_cast<std::byte>(c));
    EXPECT_TRUE(isOneColor(image));
    for (const std::size_t at : {0U, 1U, 52U, 104U}) {
        Image other = image;
        other.data[at] ^= std::byte{1};
        EXPECT_FALSE(isOneColor(other)) << at;
    }
    EXPECT_TRUE(isOneColor(testing::noisyImage(1, 1, 4, Component::u16)));
    EXPECT_FALSE(isOneColor(testing::noisyImage(2, 1, 4, Component::u16)));
    EXPECT_TRUE(isOneColor({}));
}

TEST(InspectImage, NumbersThatAreNotFiniteAreCounted) {
    const NonFinite found = countNonFinite(floatImage(2, 2, 2, {0, 1, 2, 3, 4, kNan, -kInfinity, kNan}));
    EXPECT_EQ(found.nan, 2U);
    EXPECT_EQ(found.infinite, 1U);
    EXPECT_EQ(found.x, 0);
    EXPECT_EQ(found.y, 1);
    EXPECT_EQ(countNonFinite(floatImage(1, 1, 1, {3e38F})).nan, 0U);
    EXPECT_EQ(countNonFinite(testing::noisyImage(4, 4, 4, Component::u16)).nan, 0U);
}

/// As NumPy and ImageMagick have it: an alpha of 1 is no part of a colour picture.
TEST(CompareImages, AnOpaqueAlphaIsNotInTheMean) {
    for (const Component type : {Component::u8, Component::u16, Component::f32}) {
        const Image colors =
            withType(Image{1, 2, 3, Component::u8, testing::bytesOf({9, 9, 9, 9, 9, 9})}, type);
        const Image others =
            withType(Image{1, 2, 3, Component::u8, testing::bytesOf({9, 9, 9, 9, 60, 9})}, type);
        const double mean = compare(colors, others).rootMeanSquare;
        EXPECT_NEAR(mean, std::sqrt(51. * 51 / 6) / 255, 1e-7);
        EXPECT_DOUBLE_EQ(compare(withComponents(colors, 4), withComponents(others, 4)).rootMeanSquare, mean);
        EXPECT_DOUBLE_EQ(compare(withComponents(colors, 4), others).rootMeanSquare, mean);
    }
    const Image a{1, 1, 4, Component::u8, testing::bytesOf({0, 0, 0, 254})};
    const Image b{1, 1, 4, Component::u8, testing::bytesOf({6, 0, 0, 254})};
    EXPECT_DOUBLE_EQ(compare(a, b).rootMeanSquare, 3. / 255);
}

TEST(ConvertImage, ComponentsAreCopiedAndCompleted) {
    const Image grey{1, 1, 1, Component::u8, testing::bytesOf({9})};
    const Image greyAlpha{1, 1, 2, Component::u8, testing::bytesOf({9, 4})};
    const Image rgba{1, 1, 4, Component::u8, testing::bytesOf({1, 2, 3, 4})};
    EXPECT_EQ(withComponents(grey, 4).data, testing::bytesOf({9, 9, 9, 255}));
    EXPECT_EQ(withComponents(greyAlpha, 4).data, testing::bytesOf({9, 9, 9, 4}));
    EXPECT_EQ(withComponents(greyAlpha, 3).data, testing::bytesOf({9, 9, 9}));
    EXPECT_EQ(withComponents(rgba, 3).data, testing::bytesOf({1, 2, 3}));
    EXPECT_EQ(withComponents(rgba, 2).data, testing::bytesOf({1, 4}));
    EXPECT_EQ(withComponents(rgba, 4).data, rgba.data);
}

TEST(ConvertImage, IntegersAreRoundedLimitedAndWidenedExactly) {
    const Image values = floatImage(7, 1, 1, {-1, 0, .5F, 1, 2, kNan, 1.4F / 255});
    EXPECT_EQ(withType(values, Component::u8).data, testing::bytesOf({0, 0, 128, 255, 255, 0, 1}));
    Image all{256, 1, 1, Component::u8, {}};
    for (int i = 0; i < 256; ++i) all.data.push_back(static_cast<std::byte>(i));
    for (const Component type : {Component::u16, Component::f32})
        EXPECT_EQ(withType(withType(all, type), Component::u8).data, all.data);
    EXPECT_EQ(testing::pixelAt(withType(all, Component::u16), 200, 0)[0], 200 * 257);
}

}  // namespace
}  // namespace glibra::image
