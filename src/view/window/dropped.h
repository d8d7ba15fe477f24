#pragma once
// Handles files that are dropped on the window.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "view/window/tabs.h"

namespace glibra::view {

struct Dropped {
    bool isScene = false;            ///< the caller opens it
    std::optional<std::size_t> tab;  ///< the tab that shows the file now; the caller switches to it
    std::string notice;              ///< a message for the status line; may be empty
};

/// A scene is left to the caller to open. A shader or included file is shown as text in the tab whose scene
/// uses it (the shown tab is tried first), a texture in the inspector, and a model at the line that names it.
/// A folder opens the file dialog in that folder. Any other file only gives a message.
Dropped takeDroppedFile(Tabs& tabs, const std::filesystem::path& file);

}  // namespace glibra::view
