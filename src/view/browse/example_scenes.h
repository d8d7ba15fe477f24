#pragma once
// Lists the example scenes that ship with glibra, and the chapters that they are about.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace glibra::view {

struct ExampleScene {
    std::filesystem::path file;
    std::string topic;    ///< its folder in `glib`
    std::string name;     ///< file name without extension
    std::string summary;  ///< its first comment line, without exercise numbers
    std::string source;   ///< the book and the chapter that it is about: "Graphics Shaders, chapter 4"
};

/// All scenes in ROOT/glib and its folders, sorted by topic and name, with the topic "start" first. Their
/// sources are those that the table in ROOT/glib/README.md states.
std::vector<ExampleScene> exampleScenes(const std::filesystem::path& root);

/// All chapters of the scenes, in their order.
std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes);

/// True if the scene is about that chapter; an empty one stands for all.
bool isOfChapter(const ExampleScene& scene, const std::string& chapter);

}  // namespace glibra::view
