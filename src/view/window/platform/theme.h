#pragma once
// Fonts, colours and spacing of the window.

struct ImFont;

namespace glibra::view {

/// Loads the fonts of panels and of code for that scale. Call it once, before the first frame.
void loadFonts(float scale);
/// The monospaced font for code.
ImFont* codeFont();

/// How many characters of code fit after a line number in the current window. codeFont() must be in use.
int roomForCode();

/// Sets colours and spacing.
void applyTheme(bool light, float scale);

}  // namespace glibra::view
