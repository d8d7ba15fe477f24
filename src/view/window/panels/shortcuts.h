#pragma once
// The keys of the window. Each panel's row has its shortcuts; the scene's own keys come first.

#include <string>
#include <vector>

#include "scene/scene.h"
#include "view/window/panels/panel.h"

namespace glibra::view {

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

}  // namespace glibra::view
