#pragma once
// The state of the file dialog, which opens a scene or asks for another file or folder.

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "view/browse/folder_list.h"

namespace glibra::view {

struct Ui;

/// What the dialog asks for in place of a scene to open.
struct FileQuestion {
    enum class Kind { open, save, folder };
    Kind kind = Kind::open;
    std::string title;
    std::string button;   ///< the button that ends the dialog: "Save"
    std::string hint;     ///< a sentence above the list; may be empty
    std::string endings;  ///< of the files that are listed, ".png .bmp"; empty: all files
    std::string entry;    ///< the proposed name
    /// Gets the chosen path. A file that is saved may exist only if the user has agreed to replace it.
    /// Returns the problem, with which the dialog stays open; empty on success.
    std::function<std::string(Ui&, const std::filesystem::path&)> chosen;
};

struct FileDialog {
    bool isWanted = false;  ///< opens in the next frame
    bool inNewTab = false;  ///< the chosen scene gets its own tab
    bool focusEntry = false;
    std::filesystem::path folder;  ///< where to begin; empty: the scene's folder
    FolderList list;
    std::array<char, 4096> entry{};
    std::optional<FileQuestion> question;  ///< nothing: a scene to open
    std::string existing;                  ///< the entry for which the dialog offers to replace the file
    std::string problem;                   ///< why the last entry was refused

    /// Opens the dialog with that question in the next frame.
    void ask(FileQuestion wanted, std::filesystem::path begin) {
        question = std::move(wanted);
        folder = std::move(begin);
        isWanted = true;
    }
};

}  // namespace glibra::view
