#pragma once
// Sets up Dear ImGui with its backends for GLFW and OpenGL.

#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

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

}  // namespace glibra::view
