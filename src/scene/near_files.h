#pragma once
// The files whose names come closest to one that does not exist, for "cannot find 'cow.obj'; nearest:
// 'cows.obj'".

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/file_lookup.h"

namespace glibra::scene {

/// Up to three names of ordinary files in these folders, nearest first (by glib::editDistance; of equally
/// near ones the first folder's, then byte order). Near means: at most a third of the name changed, or two
/// bytes.
std::vector<std::string> nearestFiles(std::string_view name, std::span<const std::filesystem::path> folders,
                                      FolderListings& listings);

}  // namespace glibra::scene
