#pragma once
// The example scenes that come with glibra.

#include <filesystem>
#include <string>
#include <vector>

namespace glibra::view {

struct ExampleScene {
    std::filesystem::path file;
    std::string topic;    ///< its folder below `glib`
    std::string name;     ///< of the file, without its ending
    std::string summary;  ///< what its first line of comment says, without the numbers of exercises
};

/// The first of these that has `glib` beside `shaders`: the given roots, the folders above the program,
/// those above the scene, and `share/glibra` in each of these folders. Empty if there is none.
std::filesystem::path exampleRoot(const std::vector<std::filesystem::path>& roots,
                                  const std::filesystem::path& scene, const std::filesystem::path& program);

/// Every scene in the folders of ROOT/glib, by topic and name.
std::vector<ExampleScene> exampleScenes(const std::filesystem::path& root);

}  // namespace glibra::view
