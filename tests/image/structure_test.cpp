// The structural difference: what it ignores, what it detects, and its value where it can be computed by
// hand.

#include "image/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/image.h"
#include "support.h"

namespace glibra::image {
namespace {

using testing::greyImage;

constexpr int kStructureSide = 128;

/// A disc at (64 + dx, 64 + dy).
Image disc(double dx, double dy, double radius = 40) {
    return greyImage([=](int x, int y) { return std::hypot(x - 64 - dx, y - 64 - dy) < radius ? 220 : 30; },
                     kStructureSide, kStructureSide);
}

Image noisyCells(std::uint32_t seed, int cell) {
    return greyImage(
        [=](int x, int y) {
            return testing::hash(seed + static_cast<std::uint32_t>(y / cell * 1000 + x / cell)) >> 24;
        },
        kStructureSide, kStructureSide);
}

TEST(Structure, EqualPicturesHaveNone) {
    for (const Component type : {Component::u8, Component::u16, Component::f32}) {
        const Image image = testing::noisyImage(50, 37, 4, type);
        EXPECT_EQ(structure(image, image).difference, 0);
    }
}

TEST(Structure, EdgesMayMoveByAPixelInAnyDirection) {
    for (const double dy : {-1., 0., 1.})
        for (const double dx : {-1., 0., 1.})
            EXPECT_LT(structure(disc(0, 0), disc(dx, dy)).difference, 1e-4) << dx << ' ' << dy;
    EXPECT_LT(structure(disc(0, 0), disc(.4, .3)).difference, .05) << "by a part of a pixel";
    EXPECT_GT(structure(disc(0, 0), disc(4, 0)).difference, .1);
}

TEST(Structure, MissingShapesAreDetectedInPicturesOfAnySize) {
    for (const int side : {64, 128, 512}) {
        const auto empty = [](int, int) { return 90; };
        const auto triangle = [](int x, int y) { return y > 20 && y < 30 && x > 20 && x < y ? 180 : 90; };
        const StructureResult result =
            structure(greyImage(triangle, side, side), greyImage(empty, side, side));
        EXPECT_GT(result.difference, .05) << side;
        EXPECT_LE(result.x, 20);
        EXPECT_GT(result.x + result.width, 30);
    }
}

TEST(Structure, OtherNoiseIsDetected) {
    for (const int cell : {1, 2, 4, 8})
        EXPECT_GT(structure(noisyCells(1, cell), noisyCells(9, cell)).difference, .5) << cell;
}

TEST(Structure, BrightnessLosesTheSquareOfItsChangeInSixteenths) {
    const auto flat = [](int value) {
        return greyImage([=](int, int) { return value; }, kStructureSide, kStructureSide);
    };
    EXPECT_NEAR(structure(flat(100), flat(104)).difference, 4. * 4 / (16 * 16), 1e-6);
    EXPECT_EQ(structure(flat(100), flat(117)).difference, 1);
}

TEST(Structure, IsContrastAndStructureOfSsimWhereNoShiftHelps) {
    // Stripes of one contrast against stripes of another: shifts keep or reverse the phase, so the formula
    // can be evaluated by hand. Variances 100 and 900, covariance 300, equal means.
    const auto stripes = [](int amplitude) {
        return greyImage([=](int x, int) { return 128 + (x / 2 % 2 == 0 ? amplitude : -amplitude); },
                         kStructureSide, kStructureSide);
    };
    const double c = std::pow(.03 * 255, 2);
    EXPECT_NEAR(structure(stripes(10), stripes(30)).difference, 1 - (2 * 300 + c) / (100 + 900 + c), 1e-3);
}

TEST(Structure, AlphaAndColorCount) {
    const Image a = withComponents(disc(0, 0), 4);
    for (const std::size_t component : {0U, 1U, 2U, 3U}) {
        Image b = a;
        for (std::size_t i = 0; i < std::size_t{16} * kStructureSide; ++i)
            b.data[4 * i + component] ^= std::byte{0x60};
        EXPECT_GT(structure(a, b).difference, .4) << component;
    }
}

TEST(Structure, NanAgainstANumberLosesTheWindowsAroundIt) {
    const Image a{16, 16, 1, Component::f32, std::vector<std::byte>(1024)};
    Image b = a;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(&b.data[4 * (std::size_t{8} * 16 + 8)], &nan, 4);
    // Only one of 7 x 7 windows has it inside; the three others that hold it can move aside.
    EXPECT_NEAR(structure(a, b).difference, 1. / 49, 1e-6);
    EXPECT_EQ(structure(b, b).difference, 0);
}

TEST(Structure, SmallPicturesAreOneWindow) {
    EXPECT_EQ(
        structure(greyImage([](int, int) { return 0; }, 3, 2), greyImage([](int, int) { return 255; }, 3, 2))
            .difference,
        1);
    EXPECT_EQ(structure({}, {}).difference, 1);
    EXPECT_EQ(structure(disc(0, 0), greyImage([](int, int) { return 0; }, 3, 2)).difference, 1);
}

}  // namespace
}  // namespace glibra::image
