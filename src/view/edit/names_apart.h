#pragma once
// Names of files in a list, with as much of their folders as tells equal names apart.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace glibra::view {

/// The shortest end of each path that no other one has: "planet.glib", or "first/planet.glib" and
/// "second/planet.glib". Equal paths have equal names.
std::vector<std::string> namesApart(std::span<const std::filesystem::path> files);

}  // namespace glibra::view
