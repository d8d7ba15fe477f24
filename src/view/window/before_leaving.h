#pragma once
// What the user is asked before unsaved texts or values would be lost; nothing if none would be.

#include <cstddef>
#include <filesystem>
#include <optional>

#include "view/window/tabs.h"

namespace glibra::view {

/// Before a scene is opened in the shown tab.
std::optional<Question> beforeOpening(const Tabs& tabs, const std::filesystem::path& scene);
/// Before a tab is closed. The values of an example do not count, because they cannot be saved into it.
std::optional<Question> beforeClosing(const Tabs& tabs, std::size_t tab);
/// Before all are closed: only unsaved text counts, because the tabs come back with their values.
std::optional<Question> beforeQuitting(const Tabs& tabs);

}  // namespace glibra::view
