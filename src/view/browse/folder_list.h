#pragma once
// What a file dialog shows of a folder.

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
    std::vector<FolderEntry> entries;  ///< folders first; by name without regard to case
    std::string problem;               ///< why there are none, as a sentence; empty if there could be
};

/// The folders in it and the files with that ending, hidden ones left out; links count as what they lead to.
FolderList listFolder(const std::filesystem::path& folder, std::string_view ending);

}  // namespace glibra::view
