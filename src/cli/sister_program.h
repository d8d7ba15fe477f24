#pragma once
// Programs of their own that a subcommand of glibra starts: glibra-view and glibra-bench. They are separate
// so that glibra neither links nor builds their libraries.

#include <string>
#include <vector>

namespace glibra::cli {

struct SisterProgram {
    const char* name;     ///< file name: "glibra-view"
    const char* missing;  ///< end of the error message if the file is missing: what to do instead
};

/// Replaces this process by the program, found beside glibra (in a build folder) or in lib/glibra
/// (installed). Returns only if that fails: prints one error line and returns kNoDriver.
int becomeProgram(const SisterProgram& program, const std::vector<std::string>& arguments);

// The window for scenes that a command line names.

/// True for a scene that exists, a folder, and a name that ends as a scene's.
bool isSceneOrFolder(const std::string& word);

/// Becomes the window, with these arguments of `glibra view`; a folder among them stands for its scenes.
/// Returns only if there is no window: what is missing and how to draw a picture has been printed, and the
/// result is the exit status.
int openWindow(const std::vector<std::string>& arguments);

/// The message about a scene that does not exist, with the nearest name; empty if it exists.
std::string whyNoScene(const std::string& scene);

}  // namespace glibra::cli
