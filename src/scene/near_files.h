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

/// Returns up to three names of ordinary files in these folders, nearest first by glib::editDistance. Equal
/// distances are ordered by folder, then by bytes. A name is near if at most a third of it differs, or two
/// bytes.
std::vector<std::string> nearestFiles(std::string_view name, std::span<const std::filesystem::path> folders,
                                      FolderListings& listings);

}  // namespace glibra::scene
