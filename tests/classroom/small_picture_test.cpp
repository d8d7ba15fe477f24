// Pictures of pages that are sent, and pictures that were cut from others.
#include "classroom/hand_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "classroom/effect.h"

namespace glibra::classroom {
namespace {

/// A picture with detail everywhere: waves, and noise of so many steps.
image::Image detailed(int width, int height, int noise, std::uint32_t seed = 1) {
    image::Image made{width, height, 3, image::Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int k = 0; k < 3; ++k) {
                seed = seed * 1664525U + 1013904223U;
                const double wave = std::sin(.05 * x * (1 + k) + .002 * x * y) * std::cos(.07 * y);
                const int value =
                    static_cast<int>(128 + 90 * wave) + static_cast<int>(seed >> 16U) % (noise + 1);
                made.data.push_back(static_cast<std::byte>(std::min(value, 255)));
            }
    return made;
}

image::Image cut(const image::Image& from, int left, int top, int width, int height, int turn = 0,
                 int brighter = 0) {
    image::Image made{width, height, 3, image::Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int i = 3 * left; i < 3 * (left + width); ++i) {
            const int row = turn != 0 ? top + height - 1 - y : top + y;
            const int value = std::to_integer<int>(from.row(row)[static_cast<std::size_t>(i)]) + brighter;
            made.data.push_back(static_cast<std::byte>(std::clamp(value, 0, 255)));
        }
    return made;
}

TEST(SmallPictures, AreSmall) {
    const std::string photograph = smallPicture(detailed(640, 480, 60));
    EXPECT_LT(photograph.size(), 90'000U) << "a PNG file of it has 900,000 bytes";
    EXPECT_TRUE(photograph.starts_with("data:image/gif;base64,R0lG"));
    const std::string flat =
        smallPicture({640, 480, 3, image::Component::u8, std::vector<std::byte>(921'600)});
    EXPECT_LT(flat.size(), 2'000U);
    EXPECT_TRUE(flat.starts_with("data:image/png;base64,iVBOR"));
    EXPECT_TRUE(isSmallPicture(photograph) && isSmallPicture(flat));
    EXPECT_FALSE(isSmallPicture("javascript:alert(1)"));
}

TEST(CutPictures, AreFoundWhereverTheyWereCut) {
    const image::Image whole = detailed(320, 240, 20);
    EXPECT_TRUE(isCutFrom(whole, whole));
    EXPECT_TRUE(isCutFrom(whole, cut(whole, 0, 0, 100, 90)));
    EXPECT_TRUE(isCutFrom(whole, cut(whole, 219, 149, 101, 91)));
    EXPECT_TRUE(isCutFrom(whole, cut(whole, 37, 61, 80, 50, 1))) << "upside down";
    EXPECT_TRUE(isCutFrom(whole, cut(whole, 37, 61, 80, 50, 0, 4))) << "saved with losses";
}

TEST(CutPictures, OthersAreNone) {
    const image::Image whole = detailed(320, 240, 20);
    EXPECT_FALSE(isCutFrom(whole, cut(detailed(320, 240, 20, 7), 0, 0, 20, 20))) << "too small to tell";
    const image::Image other = detailed(400, 300, 200, 3);
    EXPECT_FALSE(isCutFrom(whole, cut(other, 0, 0, 100, 90)));
    EXPECT_FALSE(isCutFrom(whole, other)) << "larger than the whole";
    EXPECT_FALSE(isCutFrom(whole, cut(whole, 37, 61, 80, 50, 0, 90)));
    // Flat parts are everywhere, and so are few points on them.
    const image::Image sky{320, 240, 3, image::Component::u8, std::vector<std::byte>(230'400)};
    image::Image stars = cut(sky, 0, 0, 100, 100);
    EXPECT_FALSE(isCutFrom(sky, stars));
    for (std::size_t i = 0; i < stars.data.size(); i += 301) stars.data[i] = std::byte{255};
    EXPECT_FALSE(isCutFrom(sky, stars));
}

/// The picture with a square of it brighter.
image::Image brighterAt(image::Image picture, int left, int top, int by) {
    for (int y = top; y < top + 40; ++y)
        for (int i = 3 * left; i < 3 * (left + 40); ++i) {
            std::byte& each =
                picture.data[static_cast<std::size_t>(y * picture.width * 3) + static_cast<std::size_t>(i)];
            each = static_cast<std::byte>(std::min(std::to_integer<int>(each) + by, 255));
        }
    return picture;
}

TEST(Effects, AreAlikeInAnyStrength) {
    const image::Image plain = detailed(256, 256, 20);
    const Colors before = reduced(plain), after = reduced(brighterAt(plain, 80, 100, 20));
    for (const int by : {40, 20, 9, 5, 2}) {
        const auto effect = effectOf(before, after, before, reduced(brighterAt(plain, 80, 100, by)));
        ASSERT_TRUE(effect);
        EXPECT_GT(effect->likeness, 0.97) << by;
        EXPECT_EQ(keptLikeness(*effect), 1) << by;
        EXPECT_FALSE(changesOtherwise(*effect)) << by;
    }
    const auto none = effectOf(before, after, before, before);
    ASSERT_TRUE(none);
    EXPECT_EQ(none->likeness, 0);
    EXPECT_EQ(keptLikeness(*none), 0);
    image::Image stray = plain;
    stray.data[0] = stray.data[0] == std::byte{255} ? std::byte{253} : std::byte{255};
    EXPECT_EQ(effectOf(before, after, before, reduced(stray))->likeness, 0) << "a stray pixel";
}

}  // namespace
}  // namespace glibra::classroom
