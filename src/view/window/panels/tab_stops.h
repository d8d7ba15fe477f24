#pragma once
// The keyboard alone reaches every widget: Tab and Shift+Tab go from one to the next, F6 to the next window,
// Enter and the space bar do what a click does. In menus, lists and dialogs the arrow keys choose.

#include <string_view>

#include "view/window/panels/ui.h"

namespace glibra::view {

/// tabStop(ui) (ui.h): the last widget is a stop; it has a frame while it has the keyboard. The same for what
/// is no widget of ImGui. Returns true if it was activated in this frame.
bool tabStop(Ui& ui, unsigned id);

/// Before the widgets of a frame: the keys that go from stop to stop and activate them.
void beginStops(Ui& ui);
/// True if the space bar activates the stop that has the keyboard.
bool takesSpace(const Ui& ui);
/// True if a Key statement of the scene names that key.
bool isUsedByScene(const Ui& ui, std::string_view key);
/// The number of the window that the next widget belongs to (TabStop::window).
unsigned thisWindow();

}  // namespace glibra::view
