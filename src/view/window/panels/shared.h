#pragma once
// The state that all tabs of the window share.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/live/knobs.h"
#include "view/edit/edited_file.h"
#include "view/edit/recovery.h"
#include "view/edit/save_values.h"
#include "view/window/platform/settings.h"

namespace glibra::view {

/// A tab in the tab bar.
struct TabTitle {
    std::string label;
    std::filesystem::path path;
    int id = 0;  ///< does not change when other tabs are closed
    bool isUnsaved = false, hasError = false;
};

/// The changed values of a scene, as they would be saved.
struct UnsavedValues {
    std::filesystem::path scene;
    std::vector<render::Knob> knobs;
    std::vector<ChosenFile> files;
};

/// An action of the user that would lose unsaved text or values: it needs confirmation.
struct Question {
    enum class About { openScene, closeTab, quit };
    About about = About::quit;
    std::filesystem::path scene;               ///< to open
    std::size_t tab = 0;                       ///< to close
    std::vector<std::filesystem::path> files;  ///< the files with unsaved text
    std::vector<UnsavedValues> values;         ///< the scenes whose changed values would be lost
    std::string problem;                       ///< why they could not be saved
};

/// The user's answer to a question.
struct Answer {
    Question question;
    bool isConfirmed = false;
    bool inNewTab = false;  ///< the scene to open gets its own tab, so that nothing is lost
};

struct Shared {
    Settings settings;
    std::filesystem::path keptValues;  ///< the folder of ValueKeeper; empty: values are not kept
    float scale = 1;                   ///< of texts and widgets
    bool showPanel = true, showLabels = false;
    std::optional<int>
        samples;  ///< per pixel on the screen, instead of the setting, as the command line says
    /// Of pictures in pixels, instead of the scene's size, as the command line says: width and height.
    std::optional<std::pair<int, int>> size;
    std::map<std::filesystem::path, EditedFile> sources;       ///< the files that source panels have shown
    SafetyCopies copies{stateFolder()};                        ///< of those that are not saved
    std::map<std::filesystem::path, RecoveredText> recovered;  ///< offered, until the user has decided
    std::vector<TabTitle> tabs;
    std::size_t shownTab = 0;
    bool marksWidgets = false;  ///< positions of widgets are stored, for `--state`
    bool textTakesTab = false;  ///< a source has the keyboard: Tab is a letter
    bool tabChanged = false;    ///< the tab bar has to select the shown tab
    std::optional<Question> question;
    std::optional<Answer> answer;
};

}  // namespace glibra::view
