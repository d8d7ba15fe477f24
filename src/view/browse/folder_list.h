#pragma once
// Lists a folder for a file dialog.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::view {

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

}  // namespace glibra::view
