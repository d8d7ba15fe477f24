#pragma once
// The colours of the window, light and dark, as values without a GUI library. The theme passes them to Dear
// ImGui. Neutral greys and one accent, so that they do not influence how the colours of the picture are
// judged.

#include <cstdint>
#include <vector>

namespace glibra::view {

/// sRGB, each component 0..1.
struct Color {
    float r = 0, g = 0, b = 0;
    friend bool operator==(const Color&, const Color&) = default;
};

/// The colour of 0xRRGGBB.
constexpr Color colorOf(std::uint32_t hexadecimal) {
    const auto component = [&](int shift) {
        return static_cast<float>(hexadecimal >> shift & 0xFFU) / 255.F;
    };
    return {component(16), component(8), component(0)};
}

struct Palette {
    Color well;                              ///< around the picture
    Color panel;                             ///< the background of the sections
    Color popup;                             ///< menus, tooltips
    Color frame, frameHovered, frameActive;  ///< fields and the tracks of sliders
    Color button, buttonHovered, buttonActive;
    Color section, sectionHovered, sectionActive;  ///< headings of sections, chosen rows of lists
    Color border;
    Color outline;             ///< of what is known by its shape alone: check boxes, round buttons
    Color text, dim;           ///< dim: secondary text, not disabled text
    Color accent;              ///< thumbs, check marks, the focused slider
    Color fill;                ///< the part of a slider below its value, progress
    Color selection;           ///< selected text
    Color error, warning;      ///< text
    Color banner, bannerText;  ///< the first error, over the picture
    Color keyword, type, number, comment, directive, builtin;  ///< words of code
};

const Palette& paletteOf(bool isLight);

/// Of the source's background where it stands over the picture. Its text stays readable on black and on
/// white; a test measures it.
inline constexpr float kSourceOpacity = .92F;

/// What the code editor paints over its background and below or above its text, which has the colours of the
/// palette and stays readable on every tint (contrast 4.5:1); a test measures it. Tints of lines and words
/// lie over Palette::panel, that of a list's chosen row over Palette::popup.
enum class CodeTint { errorLine, warningLine, found, foundShown, selection, chosenRow };

struct Tint {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
};
Tint tintOf(CodeTint tint, bool isLight);

/// What is seen of a background below a tint.
Color tinted(const Color& background, const Tint& tint);

}  // namespace glibra::view
