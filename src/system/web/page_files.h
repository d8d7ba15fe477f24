#pragma once
// The files of a page: what stands in place of a disk. Programs see their names by std::filesystem; their
// contents are given by a FileReader, so that nothing copies them.

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace glibra::system {

/// Contents by name. A name has no '/' at its beginning and no "..".
using PageFiles = std::map<std::string, std::string, std::less<>>;
PageFiles& pageFiles();

/// The name of the file or folder at a path; empty for the page itself.
std::string nameInPage(const std::filesystem::path& path);

}  // namespace glibra::system
