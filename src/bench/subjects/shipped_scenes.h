#pragma once
// The scenes that ship with glibra, and how each is drawn best.

#include <glibra/result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::bench {

struct ShippedScene {
    std::string name;  ///< "shading/sphere"
    std::filesystem::path path;
    /// "NAME=VALUE" that make its tessellation the finest its sliders allow; empty where it has none, or
    /// where the level is what the picture is about.
    std::vector<std::string> finest;
};

/// By name. They are looked for in the folders of GLIBRA_PATH, and in the nearest folder with `glib` and
/// `shaders` in it above the current one and above the program. file-E01 if there are none.
Result<std::vector<ShippedScene>> shippedScenes();

}  // namespace glibra::bench
