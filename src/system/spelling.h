#pragma once
// Names of files, where the system finds a file also by a name in another case.

#include <filesystem>

namespace glibra::system {

/// The last part of a path as its folder has it. That of the path, where the system tells names in other
/// cases apart, or has no such file.
std::filesystem::path nameInFolder(const std::filesystem::path& path);

}  // namespace glibra::system
