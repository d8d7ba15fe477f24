#pragma once
// Lists the example scenes that ship with glibra, and the chapters that they are about.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

// Lists a folder for a file dialog.

struct FolderEntry {
    std::string name;
    bool isFolder = false;
};

struct FolderList {
    std::filesystem::path folder;      ///< absolute
    std::vector<FolderEntry> entries;  ///< folders first; sorted by name, ignoring case
    std::string problem;  ///< a sentence that says why the folder cannot be read; empty on success
};

/// The folders in `folder` and the files with one of these extensions (".png .bmp"), or all files if there
/// are none, without hidden ones. Links are followed.
FolderList listFolder(const std::filesystem::path& folder, std::string_view endings);

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
