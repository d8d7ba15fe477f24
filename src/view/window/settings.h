#pragma once
// What the window remembers between runs, as JSON in the user's configuration folder.

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::view {

struct Settings {
    int windowWidth = 0, windowHeight = 0;    ///< screen coordinates; 0: as the scene wants
    float panelWidth = 0;                     ///< screen coordinates; 0: the usual
    float sourceWidth = 0, sourceHeight = 0;  ///< of the source panel beside and below the picture
    bool showSource = false;
    std::string layout;  ///< where the floating windows stand, as the GUI writes it
    bool lightTheme = false;
    std::vector<std::string> recent;  ///< scenes, the last opened first

    void addRecent(const std::filesystem::path& scene);
};

/// $XDG_CONFIG_HOME/glibra/view.json, by default ~/.config/glibra/view.json; empty without a home.
std::filesystem::path settingsFile();
/// The defaults if there are none or they are damaged.
Settings readSettings(const std::filesystem::path& file);
/// What cannot be written is not remembered.
void writeSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace glibra::view
