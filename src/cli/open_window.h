#pragma once
// The window for scenes that a command line names.

#include <string>
#include <vector>

namespace glibra::cli {

/// True for a scene that exists, a folder, and a name that ends as a scene's.
bool isSceneOrFolder(const std::string& word);

/// Becomes the window, with these arguments of `glibra view`; a folder among them stands for its scenes.
/// Returns only if there is no window: what is missing and how to draw a picture has been printed, and the
/// result is the exit status.
int openWindow(const std::vector<std::string>& arguments);

/// The message about a scene that does not exist, with the nearest name; empty if it exists.
std::string whyNoScene(const std::string& scene);

}  // namespace glibra::cli
