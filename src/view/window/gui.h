#pragma once
// Dear ImGui with its two backends.

#include "view/window/display.h"
#include "view/window/settings.h"

namespace glibra::view {

class Gui {
  public:
    /// In the display's context, with fonts for that scale, and the theme and layout of the settings.
    Gui(const Display& display, float scale, const Settings& settings);
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
    ~Gui();
};

}  // namespace glibra::view
