#include "view/style/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glibra::view {
namespace {

constexpr Palette kDark{.well = colorOf(0x131416),
                        .panel = colorOf(0x212327),
                        .popup = colorOf(0x2A2D32),
                        .frame = colorOf(0x2D3137),
                        .frameHovered = colorOf(0x363B42),
                        .frameActive = colorOf(0x3A4048),
                        .button = colorOf(0x353A41),
                        .buttonHovered = colorOf(0x434953),
                        .buttonActive = colorOf(0x4D5560),
                        .section = colorOf(0x2A2D32),
                        .sectionHovered = colorOf(0x353A42),
                        .sectionActive = colorOf(0x3E444D),
                        .border = colorOf(0x42474F),
                        .outline = colorOf(0x858C96),
                        .text = colorOf(0xE6E8EB),
                        .dim = colorOf(0xABB1BA),
                        .accent = colorOf(0x4C9CE8),
                        .fill = colorOf(0x2B5378),
                        .selection = colorOf(0x203B55),
                        .error = colorOf(0xFF9288),
                        .warning = colorOf(0xF0B54A),
                        .banner = colorOf(0x8C1414),
                        .bannerText = colorOf(0xFFFFFF),
                        .keyword = colorOf(0xD791EB),
                        .type = colorOf(0x6EB9FA),
                        .number = colorOf(0xEBB46E),
                        .comment = colorOf(0x8AB08A),
                        .directive = colorOf(0xCDC87D),
                        .builtin = colorOf(0x6ED2C8)};

constexpr Palette kLight{.well = colorOf(0xDDE0E4),
                         .panel = colorOf(0xF4F5F7),
                         .popup = colorOf(0xFFFFFF),
                         .frame = colorOf(0xFFFFFF),
                         .frameHovered = colorOf(0xEDF3FA),
                         .frameActive = colorOf(0xE1ECF8),
                         .button = colorOf(0xE3E6EA),
                         .buttonHovered = colorOf(0xD5DAE0),
                         .buttonActive = colorOf(0xC6CDD6),
                         .section = colorOf(0xE6E9ED),
                         .sectionHovered = colorOf(0xDADFE5),
                         .sectionActive = colorOf(0xCDD4DC),
                         .border = colorOf(0xB4BAC3),
                         .outline = colorOf(0x7F8690),
                         .text = colorOf(0x1A1C20),
                         .dim = colorOf(0x535963),
                         .accent = colorOf(0x1B6AB8),
                         .fill = colorOf(0xB9D7F3),
                         .selection = colorOf(0xCFE4FA),
                         .error = colorOf(0xA8201A),
                         .warning = colorOf(0x7A4A00),
                         .banner = colorOf(0x8C1414),
                         .bannerText = colorOf(0xFFFFFF),
                         .keyword = colorOf(0x96288C),
                         .type = colorOf(0x145FAA),
                         .number = colorOf(0x8F4A00),
                         .comment = colorOf(0x416B41),
                         .directive = colorOf(0x6B5010),
                         .builtin = colorOf(0x006A6A)};

}  // namespace

const Palette& paletteOf(bool isLight) {
    return isLight ? kLight : kDark;
}

Tint tintOf(CodeTint tint, bool isLight) {
    switch (tint) {
        case CodeTint::errorLine:
            return isLight ? Tint{220, 50, 40, 22} : Tint{220, 50, 40, 40};
        case CodeTint::warningLine:
            return isLight ? Tint{230, 170, 30, 34} : Tint{230, 170, 30, 22};
        case CodeTint::found:
            return isLight ? Tint{220, 180, 40, 80} : Tint{200, 160, 40, 28};
        case CodeTint::foundShown:
            return isLight ? Tint{250, 170, 40, 92} : Tint{200, 160, 40, 36};
        case CodeTint::selection:
            return isLight ? Tint{66, 150, 250, 56} : Tint{66, 150, 250, 50};
        case CodeTint::chosenRow:
            break;
    }
    return isLight ? Tint{66, 150, 250, 60} : Tint{66, 150, 250, 50};
}

Color tinted(const Color& background, const Tint& tint) {
    constexpr float kWhole = 255;
    const float alpha = static_cast<float>(tint.alpha) / kWhole;
    const auto mixed = [&](std::uint8_t top, float below) {
        return alpha * static_cast<float>(top) / kWhole + (1 - alpha) * below;
    };
    return {mixed(tint.red, background.r), mixed(tint.green, background.g), mixed(tint.blue, background.b)};
}

}  // namespace glibra::view
