#include "view/style/palette.h"

#include <gtest/gtest.h>

#include <vector>

#include "contrast.h"

namespace glibra::view {
namespace {

/// A colour of text and one behind it that occur together in the window.
struct TextPair {
    const char* name;
    Color text, background;
};

/// All of them. Disabled widgets are not listed: their text is faded on purpose.
std::vector<TextPair> textPairs(const Palette& p) {
    return {{"text on the panel", p.text, p.panel},
            {"text in a popup", p.text, p.popup},
            {"text around the picture", p.text, p.well},
            {"text in a field", p.text, p.frame},
            {"text in a hovered field", p.text, p.frameHovered},
            {"text in an active field", p.text, p.frameActive},
            {"text on a button", p.text, p.button},
            {"text on a hovered button", p.text, p.buttonHovered},
            {"text on a pressed button", p.text, p.buttonActive},
            {"text on a section", p.text, p.section},
            {"text on a hovered section", p.text, p.sectionHovered},
            {"text on a pressed section", p.text, p.sectionActive},
            {"text on the filled part of a slider", p.text, p.fill},
            {"selected text", p.text, p.selection},
            {"dim text on the panel", p.dim, p.panel},
            {"dim text in a popup", p.dim, p.popup},
            {"dim text around the picture", p.dim, p.well},
            {"dim text in a field", p.dim, p.frame},
            {"dim text in a hovered field", p.dim, p.frameHovered},
            {"dim text in an active field", p.dim, p.frameActive},
            {"dim text on a section", p.dim, p.section},
            {"dim text on a hovered section", p.dim, p.sectionHovered},
            {"an error on the panel", p.error, p.panel},
            {"an error in a popup", p.error, p.popup},
            {"an error on a hovered section", p.error, p.sectionHovered},
            {"an error on a tab", p.error, p.button},
            {"the first error over the picture", p.bannerText, p.banner},
            {"a keyword", p.keyword, p.panel},
            {"a type", p.type, p.panel},
            {"a number", p.number, p.panel},
            {"a comment", p.comment, p.panel},
            {"a directive", p.directive, p.panel},
            {"a built-in name", p.builtin, p.panel},
            {"a selected keyword", p.keyword, p.selection},
            {"a selected type", p.type, p.selection},
            {"a selected number", p.number, p.selection},
            {"a selected comment", p.comment, p.selection},
            {"a selected directive", p.directive, p.selection},
            {"a selected built-in name", p.builtin, p.selection},
            {"a warning on the panel", p.warning, p.panel},
            {"a warning in a popup", p.warning, p.popup},
            {"a warning on a hovered section", p.warning, p.sectionHovered}};
}

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

TEST(Palette, ThumbsAndOutlinesAreSeenInBothThemes) {
    for (const bool isLight : {false, true}) {
        const Palette& p = paletteOf(isLight);
        EXPECT_GE(contrast(p.accent, p.frame), kSeen);
        EXPECT_GE(contrast(p.accent, p.panel), kSeen);
        EXPECT_GE(contrast(p.accent, p.button), kSeen);
        EXPECT_GE(contrast(p.outline, p.frame), kSeen);
        EXPECT_GE(contrast(p.outline, p.panel), kSeen);
        EXPECT_GE(contrast(p.outline, p.popup), kSeen);
    }
}

TEST(Palette, OneThemeIsDarkAndTheOtherLight) {
    const Color white = colorOf(0xFFFFFF);
    EXPECT_GT(contrast(paletteOf(false).panel, white), 10);
    EXPECT_LT(contrast(paletteOf(true).panel, white), 1.3);
}

}  // namespace
}  // namespace glibra::view
