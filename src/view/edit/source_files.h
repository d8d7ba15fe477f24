#pragma once
// The text files that a scene is made of, for an editor.

#include <filesystem>
#include <string>
#include <vector>

#include "view/scene/live_scene.h"

namespace glibra::view {

struct SourceFile {
    std::filesystem::path path;
    std::string label;  ///< its name; with its folder where another has the same name
    std::string role;   ///< "scene", "vertex shader of Dots, Lines", "included"
};

/// The scene, the shaders in the order of the pipeline and the programs, the files they include. Each file
/// once; those that were not found are left out.
std::vector<SourceFile> sourceFiles(const LiveScene& live);

}  // namespace glibra::view
