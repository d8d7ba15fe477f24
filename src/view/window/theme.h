#pragma once
// How the window looks.

struct ImFont;

namespace glibra::view {

/// The fonts of panels and of programs for that scale, once, before the first frame.
void loadFonts(float scale);
/// The one for the text of programs: all its characters are equally wide.
ImFont* codeFont();

/// Characters of code that fit behind a line number, with codeFont() in use.
int roomForCode();

/// Colours and spacing.
void applyTheme(bool light, float scale);

}  // namespace glibra::view
