#pragma once
// The window program: a session a tab, their panels, and the loop that draws only what changed.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::view {

struct WindowArguments {
    std::vector<std::filesystem::path> scenes;  ///< a tab each
    std::vector<std::string> set;               ///< "NAME=VALUE", for the first
    RenderOptions options;                      ///< width and height: of the picture
    bool paused = false;
    std::filesystem::path stateFile;  ///< JSON, written after every frame that changed it
    std::filesystem::path recordFile, replayFile;
};

/// Runs until the window is closed. The diagnostics say why it could not be opened.
Diagnostics runWindow(const WindowArguments& arguments);

}  // namespace glibra::view
