#pragma once
// What the panels show, as JSON, for programs that watch or test the window.

#include <nlohmann/json.hpp>

#include "view/window/ui.h"

namespace glibra::view {

/// Adds tabs, source panel, examples, dialogs, noise, costs and what the last actions said.
void addPanels(nlohmann::ordered_json& state, const Ui& ui);

}  // namespace glibra::view
