#pragma once
// The scenes of the project, and changed ones.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace glibra::test {

/// All scenes of the project, sorted.
inline std::vector<std::filesystem::path> exampleScenes() {
    std::vector<std::filesystem::path> scenes;
    for (const char* folder : {"glib", "docs/examples", "scenes/expectations"})
        for (const auto& each :
             std::filesystem::recursive_directory_iterator(std::filesystem::path(GLIBRA_SOURCE_DIR) / folder))
            if (each.path().extension() == ".glib") scenes.push_back(each.path());
    std::ranges::sort(scenes);
    return scenes;
}

inline std::string textOf(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace glibra::test
