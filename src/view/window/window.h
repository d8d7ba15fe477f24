#pragma once
// The window program: tabs with a session each, their panels, and a loop that only draws what has changed.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glibra::view {

struct WindowArguments {
    std::vector<std::filesystem::path> scenes;  ///< one tab per scene
    std::vector<std::string> set;               ///< "NAME=VALUE", for the first scene
    RenderOptions options;                      ///< width and height are those of the picture
    bool paused = false;
    std::optional<int> samples;       ///< per pixel on the screen; without, as the settings say
    std::filesystem::path stateFile;  ///< JSON, written whenever the state has changed
    std::filesystem::path recordFile, replayFile;
};

/// Runs until the window is closed. Returns the errors if it cannot be opened, and those of `set`.
Diagnostics runWindow(const WindowArguments& arguments);

}  // namespace glibra::view
