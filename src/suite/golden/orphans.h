#pragma once
// Goldens that belong to no shot any more: of scenes and sweeps that were renamed or removed.

#include <glibra/result.h>

#include <filesystem>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

/// Returns the pictures in the golden folder of a suite that no shot of it has as its golden or as a variant
/// of it, sorted. `folder` replaces the folder as in GoldenStore::open. Nothing is returned of a folder that
/// another suite keeps its hashes in. In a folder with other files, such as scenes, only pictures count that
/// the suite's list of hashes names, because the others may be textures. Links are not followed.
std::vector<std::filesystem::path> orphanGoldens(const Suite& suite,
                                                 const std::filesystem::path& folder = {});

/// Removes them, and folders that are empty afterwards. Errors have the id file-E10.
Diagnostics removeOrphans(const std::vector<std::filesystem::path>& orphans);

}  // namespace glibra::suite
