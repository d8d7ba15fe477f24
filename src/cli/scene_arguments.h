#pragma once
// The scenes that a command line names: files, folders of scenes, and - for standard input.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/own_library.h"

namespace glibra::cli {

/// The name of the scene that comes from standard input, in messages. Its files are looked for in the current
/// folder.
inline constexpr const char* kStandardInput = "<stdin>";

struct SceneArguments {
    std::vector<std::string> scenes;
    bool hasFolder = false;                    ///< the command line names a folder
    std::optional<std::string> standardInput;  ///< its text, if it is one of the scenes
};

/// Replaces each folder by the scenes in it and below it, sorted, and reads standard input for "-". Empty on
/// success, otherwise why a folder has no scenes or standard input is no scene.
Diagnostics resolveScenes(const std::vector<std::string>& words, SceneArguments& to);

/// The options for one of the scenes: with its text if it comes from standard input.
RenderOptions optionsFor(const std::string& scene, const std::optional<std::string>& standardInput,
                         const RenderOptions& options);

// What a scene names and does not have may be in the library that glibra is installed with.

/// A note for the first of the missing files (file-E01) of a scene that the library has, with the --library
/// that finds it. Nothing if the library has none of them, or is searched already.
Diagnostics libraryHint(const std::filesystem::path& scene, const Diagnostics& diagnostics,
                        const std::filesystem::path& library = base::ownLibrary());

}  // namespace glibra::cli
