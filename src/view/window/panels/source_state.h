#pragma once
// The state of the source panel.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "view/window/panels/code_assist.h"
#include "view/window/panels/code_view.h"
#include "view/window/panels/find_bar.h"

namespace glibra::view {

/// What is shown now.
struct ShownSource {
    std::string file;  ///< empty: no text
    int line = 0, column = 0;
    bool isActive = false, isChanged = false, hasConflict = false;
};

struct SourceState {
    ShownSource shown;
    std::uint64_t loaded = 0;      ///< Session::timesLoaded() of Ui::files
    std::filesystem::path chosen;  ///< one of them
    bool follow = false;           ///< the file tabs have to select `chosen`
    std::optional<Place> goTo;     ///< a place to show in this frame
    std::map<std::filesystem::path, CodeView> views;
    FindBar find;
    CodeAssist assist;
    /// Texts that are not saved and will be compiled when the user pauses, and since when they are so.
    std::map<std::filesystem::path, std::string> typedTexts;
    double typedAt = 0;          ///< ImGui::GetTime()
    bool keepsKeyboard = false;  ///< the text had the keyboard last, and nothing was clicked since but
                                 ///< windows that Esc closes
};

}  // namespace glibra::view
