#pragma once
// The settings that the window keeps between runs, as JSON in the user's configuration folder.

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::view {

struct Settings {
    int windowWidth = 0, windowHeight = 0;  ///< screen coordinates; 0: from the scene's size
    float panelWidth = 0;                   ///< screen coordinates; 0: the default
    float sourceWidth = 0,
          sourceHeight = 0;  ///< of the source panel: its width beside the picture, its height below it
    bool showSource = false;
    std::string layout;  ///< positions of the floating windows, in ImGui's format
    bool lightTheme = false;
    std::vector<std::string> recent;  ///< scene files, most recently opened first

    void addRecent(const std::filesystem::path& scene);
};

/// $XDG_CONFIG_HOME/glibra/view.json, by default ~/.config/glibra/view.json. Empty if HOME is not set.
std::filesystem::path settingsFile();
/// Missing or damaged settings get their defaults.
Settings readSettings(const std::filesystem::path& file);
/// Errors are ignored: the settings are lost then.
void writeSettings(const Settings& settings, const std::filesystem::path& file);

}  // namespace glibra::view
