#pragma once
// Names of files, where the system finds a file also by a name in another case.

#include <filesystem>

namespace glibra::system {

/// A path whose parts are as their folders have them. They are those of the path, where the system tells
/// names in other cases apart, or has no such file.
std::filesystem::path asInFolders(const std::filesystem::path& path);
/// The same, absolute and without "." and "..": one path for all names of a file but links.
std::filesystem::path wholePath(const std::filesystem::path& path);

}  // namespace glibra::system
