#pragma once
// The keyboard: the keys of the window and of the scene, and the widgets that Tab reaches.

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "view/window/panels/panel.h"
#include "view/window/panels/ui.h"

namespace glibra::view {

// The keys of the window. Each panel's row has its shortcuts; the scene's own keys come first.

/// Lets a key act that is down in this frame, as the scene's Key statements with `held` say.
void holdKey(Ui& ui, const std::string& key);
/// Handles the keys that were pressed since the last frame.
void shortcuts(Ui& ui);

/// The keys that the scene declares.
const std::vector<scene::KeyBinding>& sceneKeys(const Ui& ui);
/// What such a key does, in words.
std::string effectOf(const scene::KeyBinding& key);
/// The key of this shortcut as Key statements name it, if the scene uses it, so that the shortcut needs
/// Shift; empty otherwise.
std::string takenKey(const Ui& ui, const Shortcut& shortcut);

// The keyboard alone reaches every widget: Tab and Shift+Tab go from one to the next, F6 to the next window,
// Enter and the space bar do what a click does. In menus, lists and dialogs the arrow keys choose.

/// tabStop(ui) (ui.h): the last widget is a stop; it has a frame while it has the keyboard. The same for what
/// is no widget of ImGui. Returns true if it was activated in this frame.
bool tabStop(Ui& ui, unsigned id);

/// Before the widgets of a frame: the keys that go from stop to stop and activate them.
void beginStops(Ui& ui);
/// True if a Key statement of the scene names that key.
bool isUsedByScene(const Ui& ui, std::string_view key);
/// The number of the window that the next widget belongs to (TabStop::window).
unsigned thisWindow();

}  // namespace glibra::view
