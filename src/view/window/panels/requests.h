#pragma once
// What panels request: from the window's loop, and from other panels.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace glibra::view {

struct Ui;

/// What the panels request from the window's loop, which takes it after the frame.
struct Requests {
    std::optional<std::filesystem::path> open;
    bool inNewTab = false;  ///< for `open`
    bool reload = false;
    bool close = false;       ///< the window
    bool frames = false;      ///< further frames: something moves that the session does not know of
    bool fullScreen = false;  ///< on or off
    bool lecture = false;     ///< on or off
    bool reopenTab = false;   ///< that was closed last
    std::optional<std::size_t> showTab, closeTab;
    std::optional<std::filesystem::path> saved;  ///< the file that the source panel has written
};

/// What the file dialog asks for in place of a scene to open.
struct FileQuestion {
    enum class Kind { open, save, folder };
    Kind kind = Kind::open;
    std::string title{};
    std::string button{};   ///< the button that ends the dialog: "Save"
    std::string hint{};     ///< a sentence above the list; may be empty
    std::string endings{};  ///< of the files that are listed, ".png .bmp"; empty: all files
    std::string entry{};    ///< the proposed name
    /// Gets the chosen path. A file that is saved may exist only if the user has agreed to replace it.
    /// Returns the problem, with which the dialog stays open; empty on success.
    std::function<std::string(Ui&, const std::filesystem::path&)> chosen{};
};

/// The file dialog is to open.
struct FileRequest {
    std::optional<FileQuestion> question;  ///< nothing: a scene to open
    bool inNewTab = false;                 ///< the chosen scene gets its own tab
    std::filesystem::path folder;          ///< where to begin; empty: the scene's folder
};

/// What panels want from each other. Panel::update() of the next frame takes what it can do; the rest is
/// dropped. For the loop of the window it counts as an event.
struct Wanted {
    std::optional<FileRequest> file;
    std::optional<Place> source;           ///< the source panel opens there
    std::optional<std::string> inspected;  ///< the inspector opens with the texture of that key (textureKey)
    std::optional<std::pair<int, int>> probed;      ///< this pixel of the picture: right, down
    std::optional<std::filesystem::path> compared;  ///< this scene is shown beside that of the tab
    bool hardcopy = false;                          ///< written at once, to the next free name
    bool keyboardForText = false;                   ///< the text gets the keyboard back if it had it

    [[nodiscard]] bool any() const {
        return file || source || inspected || probed || compared || hardcopy || keyboardForText;
    }
};

}  // namespace glibra::view
