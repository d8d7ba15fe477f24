#pragma once
// Finds the files that a scene names (language, 8.6). Only ordinary files are found: folders, pipes and
// devices count as missing, and so does a file in a folder that cannot be read. No file is opened, and no
// function throws.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/interpret.h"
#include "scene/scene.h"

namespace glibra::scene {

/// A cache of folder listings. Use one for all look-ups of a scene.
class FolderListings {
  public:
    /// The names in the folder ("" is the current one) in byte order, kLargestFolder at most; none if it
    /// cannot be read.
    const std::vector<std::string>& names(const std::filesystem::path& folder);

    static constexpr std::size_t kLargestFolder = 65'536;

  private:
    std::map<std::string, std::vector<std::string>> names_;
};

/// The folders that names are relative to, in the order of the search.
struct SearchFolders {
    std::vector<std::filesystem::path>
        beside;  ///< the folder of the including file (if any), then the scene's
    std::vector<std::filesystem::path>
        library;  ///< folders of the library roots: shaders/TOPIC, shaders, textures ...
};

/// Returns the folders to search for a scene's files: the scene's own folder, the given library roots, then
/// the nearest folder, from the scene's own upwards, that contains `shaders` or `textures`. TOPIC is the path
/// of the scene's folder below `glib` of that root, or else the last part of that path. A relative
/// `scenePath` starts at the current folder.
SearchFolders searchFolders(const std::filesystem::path& scenePath, const InterpretOptions& options = {});

/// Looks up a file. The result contains file-E01 with the nearest existing names if the file is missing,
/// file-W01 if the case differs, file-W02 if only the last part of the name was found beside the scene, and
/// file-W12 if several names differ only in case.
FileReference findFile(std::string_view name, const Place& place, const SearchFolders& folders,
                       FolderListings& listings);

/// Looks up a file for #include: like findFile, but first beside the including file.
FileReference findInclude(std::string_view name, std::string_view includingPath, std::string_view scenePath,
                          const InterpretOptions& options = {});

/// True if the path leads to an ordinary file. Links are followed.
bool isOrdinaryFile(const std::filesystem::path& path);

}  // namespace glibra::scene
