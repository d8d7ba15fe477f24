#pragma once
// The state that all tabs of the window share.

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
#include "view/window/platform/settings.h"

namespace glibra::view {

/// The dialog that opens a scene.
struct FileDialog {
    bool isWanted = false;  ///< opens in the next frame
    bool inNewTab = false;  ///< the chosen scene gets its own tab
    bool focusEntry = false;
    std::filesystem::path folder;  ///< where to begin; empty: the scene's folder
    FolderList list;
    std::array<char, 4096> entry{};
};

/// A tab in the tab bar.
struct TabTitle {
    std::string label, path;
    int id = 0;  ///< does not change when other tabs are closed
    bool isUnsaved = false, hasError = false;
};

/// An action of the user that would lose unsaved text: it needs confirmation.
struct Question {
    enum class About { openScene, closeTab, quit };
    About about = About::quit;
    std::filesystem::path scene;               ///< to open
    std::size_t tab = 0;                       ///< to close
    std::vector<std::filesystem::path> files;  ///< the files with unsaved text
    std::string problem;                       ///< why they could not be saved
};

/// The user's answer to a question.
struct Answer {
    Question question;
    bool isConfirmed = false;
};

struct Shared {
    Settings settings;
    std::map<std::filesystem::path, EditedFile> sources;  ///< the files that source panels have shown
    FileDialog dialog;
    ExampleBrowser examples;
    NoiseWindow noise;
    std::vector<TabTitle> tabs;
    std::size_t shownTab = 0;
    bool marksWidgets = false;  ///< positions of widgets are stored, for `--state`
    bool tabChanged = false;    ///< the tab bar has to select the shown tab
    std::optional<Question> question;
    std::optional<Answer> answer;
};

}  // namespace glibra::view
