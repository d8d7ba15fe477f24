#pragma once
// Fonts, colours and spacing of the window.

#include "view/style/palette.h"

struct ImFont;
struct ImVec4;

namespace glibra::view {

/// Loads the fonts for that scale of texts, and replaces those that were loaded before. `density`: pixels per
/// screen coordinate. Call it between frames; the backend must upload the new texture.
void loadFonts(float scale, float density);
/// The font of headings: as large as the text, but bold.
ImFont* headingFont();
/// A smaller font: the ends of ranges, and hints.
ImFont* smallFont();
/// The monospaced font for code.
ImFont* codeFont();

/// How many characters of code fit after a line number in the current window. codeFont() must be in use.
int roomForCode();

/// Sets colours and spacing.
void applyTheme(bool light, float scale);

/// The colours of the theme that is in use.
const Palette& palette();
/// For ImGui, opaque.
ImVec4 asVector(const Color& color);
/// The unit of all spacing at scale 1, in screen coordinates: paddings and gaps are multiples of it.
inline constexpr float kSpace = 4;

}  // namespace glibra::view
