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

/// Relative luminance (WCAG 2.1).
double luminance(const Color& color) {
    const auto linear = [](float component) {
        const auto c = static_cast<double>(component);
        return c <= .04045 ? c / 12.92 : std::pow((c + .055) / 1.055, 2.4);
    };
    return .2126 * linear(color.r) + .7152 * linear(color.g) + .0722 * linear(color.b);
}

}  // namespace

const Palette& paletteOf(bool isLight) {
    return isLight ? kLight : kDark;
}

double contrast(const Color& a, const Color& b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + .05) / (darker + .05);
}

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

}  // namespace glibra::view
