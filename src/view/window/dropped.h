#pragma once
// What becomes of a file that is dropped on the window.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "view/window/tabs.h"

namespace glibra::view {

struct Dropped {
    bool isScene = false;            ///< to be opened
    std::optional<std::size_t> tab;  ///< that shows the file, and is to be shown
    std::string notice;              ///< what was done, or why nothing was, as a sentence; may be empty
};

/// A scene is to be opened. A shader or an included file is shown as text in the tab whose scene uses it, the
/// shown tab first; a texture in the inspector; a model at the line that names it. A folder opens the dialog
/// there. Everything else is refused by a sentence.
Dropped takeDroppedFile(Tabs& tabs, const std::filesystem::path& file);

}  // namespace glibra::view
