#pragma once
// What all tabs of the window have in common.

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/browse/folder_list.h"
#include "view/edit/edited_file.h"
#include "view/window/panels/example_browser.h"
#include "view/window/panels/noise_window.h"
#include "view/window/settings.h"

namespace glibra::view {

/// The dialog that opens a scene.
struct FileDialog {
    bool isWanted = false;  ///< it opens with the next frame
    bool inNewTab = false;  ///< what it opens gets a tab of its own
    bool focusEntry = false;
    std::filesystem::path folder;  ///< to begin in; empty: that of the scene
    FolderList list;
    std::array<char, 4096> entry{};
};

/// A tab as the bar shows it.
struct TabTitle {
    std::string label, path;
    int id = 0;  ///< stays the tab's when others are closed
    bool isUnsaved = false, hasError = false;
};

/// What somebody wants to do that would lose edited text, and is asked about first.
struct Question {
    enum class About { openScene, closeTab, quit };
    About about = About::quit;
    std::filesystem::path scene;               ///< to be opened
    std::size_t tab = 0;                       ///< to be closed
    std::vector<std::filesystem::path> files;  ///< with text that is not saved
    std::string problem;                       ///< why the last try to save failed
};

/// What was answered.
struct Answer {
    Question question;
    bool goesOn = false;
};

struct Shared {
    Settings settings;
    std::map<std::filesystem::path, EditedFile> sources;  ///< every file that was shown in a source panel
    FileDialog dialog;
    ExampleBrowser examples;
    NoiseWindow noise;
    std::vector<TabTitle> tabs;
    std::size_t shownTab = 0;
    bool marksWidgets = false;  ///< somebody asks where widgets stand
    bool tabChanged = false;    ///< the bar has to follow
    std::optional<Question> question;
    std::optional<Answer> answer;
};

}  // namespace glibra::view
