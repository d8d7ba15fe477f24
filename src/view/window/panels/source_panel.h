#pragma once
// The state of the source panel for one tab.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "view/edit/source_files.h"
#include "view/window/panels/code_assist.h"
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
    CodeAssist assist;
    /// Texts that are not saved and will be compiled when the user pauses, and since when they are so.
    std::map<std::filesystem::path, std::string> typedTexts;
    double typedAt = 0;          ///< ImGui::GetTime()
    bool keepsKeyboard = false;  ///< the text had the keyboard last, and nothing was clicked since but
                                 ///< windows that Esc closes
};

struct Ui;

/// Gives the keyboard back to the text, if it had it before a window in front took it.
void returnToText(Ui& ui);

}  // namespace glibra::view
