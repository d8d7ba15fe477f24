#include "view/style/palette.h"

#include <gtest/gtest.h>

#include "contrast.h"

namespace glibra::view {
namespace {

TEST(CodePalette, WordsAreReadableOnEveryTint) {
    for (const bool isLight : {false, true}) {
        const Palette& p = paletteOf(isLight);
        const Color words[] = {p.text, p.dim,    p.error,   p.warning,   p.keyword,
                               p.type, p.number, p.comment, p.directive, p.builtin};
        for (const CodeTint tint : {CodeTint::errorLine, CodeTint::warningLine, CodeTint::found,
                                    CodeTint::foundShown, CodeTint::selection})
            for (std::size_t i = 0; i < std::size(words); ++i)
                EXPECT_GE(contrast(words[i], tinted(p.panel, tintOf(tint, isLight))), kReadable)
                    << (isLight ? "light" : "dark") << ", word " << i << ", tint " << static_cast<int>(tint);
        for (const Color& word : {p.text, p.dim})
            EXPECT_GE(contrast(word, tinted(p.popup, tintOf(CodeTint::chosenRow, isLight))), kReadable);
    }
}

TEST(CodePalette, WordsAreReadableOverAnyPicture) {
    for (const bool isLight : {false, true}) {
        const Palette& p = paletteOf(isLight);
        const auto over = [&](float picture) {
            const auto mixed = [&](float panel) {
                return kSourceOpacity * panel + (1 - kSourceOpacity) * picture;
            };
            return Color{mixed(p.panel.r), mixed(p.panel.g), mixed(p.panel.b)};
        };
        const Color words[] = {p.text, p.dim,    p.error,   p.warning,   p.keyword,
                               p.type, p.number, p.comment, p.directive, p.builtin};
        for (std::size_t i = 0; i < std::size(words); ++i)
            for (const float picture : {0.F, 1.F})
                EXPECT_GE(contrast(words[i], over(picture)), kReadable)
                    << (isLight ? "light" : "dark") << ", word " << i << ", over " << picture;
    }
}

TEST(CodePalette, ATintMixesByItsAlpha) {
    const Color mixed = tinted({0, 1, .5F}, {255, 0, 255, 51});
    EXPECT_NEAR(mixed.r, .2F, 1e-6F);
    EXPECT_NEAR(mixed.g, .8F, 1e-6F);
    EXPECT_NEAR(mixed.b, .6F, 1e-6F);
}

}  // namespace
}  // namespace glibra::view
