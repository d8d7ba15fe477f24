#pragma once
// Lists the example scenes that ship with glibra.

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::view {

struct ExampleScene {
    std::filesystem::path file;
    std::string topic;    ///< its folder in `glib`
    std::string name;     ///< file name without extension
    std::string summary;  ///< its first comment line, without exercise numbers
};

/// The folder with the examples: the first one that contains both `glib` and `shaders`. Searched are `roots`,
/// then the folders above the program, then those above the scene, and `share/glibra` in each of them. Empty
/// if there is none.
std::filesystem::path exampleRoot(const std::vector<std::filesystem::path>& roots,
                                  const std::filesystem::path& scene, const std::filesystem::path& program);

/// All scenes in ROOT/glib and its folders, sorted by topic and name, with the topic "start" first.
std::vector<ExampleScene> exampleScenes(const std::filesystem::path& root);

}  // namespace glibra::view
