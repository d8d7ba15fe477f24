#pragma once
// The tints that the code editor paints over its background and below or above its text. The text itself has
// the colours of view/style/palette.h. It stays readable on every tint (contrast 4.5:1); a test measures it.

#include <cstdint>

#include "view/style/palette.h"

namespace glibra::view {

/// Tints of lines and words lie over Palette::panel, that of a list's chosen row over Palette::popup.
enum class CodeTint { errorLine, warningLine, found, foundShown, selection, chosenRow };

struct Tint {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
};
Tint tintOf(CodeTint tint, bool isLight);

/// What is seen of a background below a tint.
Color tinted(const Color& background, const Tint& tint);

}  // namespace glibra::view
