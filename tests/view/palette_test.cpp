#include "view/style/palette.h"

#include <gtest/gtest.h>

namespace glibra::view {
namespace {

constexpr double kSeen = 3;  // WCAG 2.1, 1.4.11, for parts of widgets

TEST(Palette, ContrastIsThatOfTheStandard) {
    // The figures of the standard's own examples, and of WebAIM's checker.
    EXPECT_DOUBLE_EQ(contrast(colorOf(0x000000), colorOf(0xFFFFFF)), 21);
    EXPECT_DOUBLE_EQ(contrast(colorOf(0x123456), colorOf(0x123456)), 1);
    EXPECT_NEAR(contrast(colorOf(0x777777), colorOf(0xFFFFFF)), 4.48, .01);
    EXPECT_NEAR(contrast(colorOf(0xFFFFFF), colorOf(0x0000FF)), 8.59, .01);
    EXPECT_NEAR(contrast(colorOf(0xFF0000), colorOf(0xFFFFFF)), 4.00, .01);
}

TEST(Palette, EveryTextIsReadableInBothThemes) {
    for (const bool isLight : {false, true})
        for (const TextPair& each : textPairs(paletteOf(isLight)))
            EXPECT_GE(contrast(each.text, each.background), kReadable)
                << each.name << (isLight ? ", light" : ", dark");
}

TEST(Palette, ThumbsAndBordersAreSeenInBothThemes) {
    for (const bool isLight : {false, true}) {
        const Palette& p = paletteOf(isLight);
        EXPECT_GE(contrast(p.accent, p.frame), kSeen);
        EXPECT_GE(contrast(p.accent, p.panel), kSeen);
        EXPECT_GE(contrast(p.accent, p.button), kSeen);
    }
}

TEST(Palette, OneThemeIsDarkAndTheOtherLight) {
    const Color white = colorOf(0xFFFFFF);
    EXPECT_GT(contrast(paletteOf(false).panel, white), 10);
    EXPECT_LT(contrast(paletteOf(true).panel, white), 1.3);
}

}  // namespace
}  // namespace glibra::view
