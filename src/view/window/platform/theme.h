#pragma once
// How the window looks: Dear ImGui with its backends for GLFW and OpenGL, fonts, colours and spacing.

#include <glibra/diagnostic.h>
#include <imgui.h>

#include "view/edit/source_files.h"
#include "view/style/palette.h"
#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

struct ImFont;
struct ImVec4;

namespace glibra::view {

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

// Sets up Dear ImGui with its backends for GLFW and OpenGL.

/// The scale of texts and widgets in screen coordinates: that of the display times the user's zoom.
float scaleOf(const Display& display, const Settings& settings);

class Gui {
  public:
    /// Uses the display's GL context, fonts for that scale, and the theme and layout of the settings.
    Gui(const Display& display, float scale, const Settings& settings);
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui();

    /// Changes fonts, spacing and floating windows to another scale. Call it between frames.
    void rescale(const Display& display, float from, float to, const Settings& settings);
};

// The colours of code and messages in the current theme.

ImU32 syntaxColor(SyntaxKind kind);
ImU32 tintColor(CodeTint tint);
/// The color as ImGui's draw lists take it.
ImU32 packed(const Color& color);
/// Of a message's text, and of the marks of its place.
const Color& severityColor(Severity severity);

}  // namespace glibra::view
