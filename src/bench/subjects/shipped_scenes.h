#pragma once
// The scenes that ship with glibra, and the finest setting of each.

#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::bench {

struct ShippedScene {
    std::string name;  ///< "shading/sphere"
    std::filesystem::path path;
    /// "NAME=VALUE" settings that make its tessellation as fine as its sliders allow; empty if it has none,
    /// or if the level is the subject of the picture.
    std::vector<std::string> finest;
};

/// Sorted by name. They are searched in the folders of GLIBRA_PATH, then in the nearest folder with `glib`
/// and `shaders` above the current folder, then above the program. file-E01 if there are none.
Result<std::vector<ShippedScene>> shippedScenes();

}  // namespace glibra::bench
