#pragma once
// Sets up Dear ImGui with its backends for GLFW and OpenGL.

#include "view/window/platform/display.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

class Gui {
  public:
    /// Uses the display's GL context, fonts for that scale, and the theme and layout of the settings.
    Gui(const Display& display, float scale, const Settings& settings);
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui();
};

}  // namespace glibra::view
