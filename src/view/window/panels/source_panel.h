#pragma once
// The state of the source panel for one tab.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "view/edit/source_files.h"
#include "view/window/panels/code_editor.h"
#include "view/window/panels/find_bar.h"

namespace glibra::view {

struct SourcePanel {
    std::vector<SourceFile> files;
    std::uint64_t loaded = 0;      ///< Session::timesLoaded() of `files`
    std::filesystem::path chosen;  ///< one of them
    bool follow = false;           ///< the file tabs have to select `chosen`
    std::optional<Place> goTo;     ///< a place to show in the next frame
    std::map<std::filesystem::path, CodeView> views;
    FindBar find;
};

}  // namespace glibra::view
