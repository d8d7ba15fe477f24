#pragma once
// What the source panel keeps of one tab's scene.

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
    bool follow = false;           ///< the bar of tabs has to show `chosen`
    std::optional<Place> goTo;     ///< a place that is to be shown
    std::map<std::filesystem::path, CodeView> views;
    FindBar find;
};

}  // namespace glibra::view
