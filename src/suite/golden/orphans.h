#pragma once
// Goldens that belong to no shot any more: of scenes and sweeps that were renamed or removed.

#include <glibra/result.h>

#include <filesystem>
#include <span>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

/// Returns the pictures in the golden folder of a suite that no shot of it, nor of `others`, has as its
/// golden or as a variant of it, sorted. `folder` replaces the folders as in GoldenStore::open. Suites beside
/// this one count as others. Nothing is returned of a folder that another suite keeps its hashes in. Only
/// pictures count that the suite's list of hashes names if the folder has other files, such as scenes,
/// because the pictures may be textures, or if a TOML file beside the suite cannot be read as a suite. Links
/// are not followed.
std::vector<std::filesystem::path> orphanGoldens(const Suite& suite, const std::filesystem::path& folder = {},
                                                 std::span<const Suite> others = {});

/// Removes them, and folders that are empty afterwards. Errors have the id file-E10.
Diagnostics removeOrphans(const std::vector<std::filesystem::path>& orphans);

}  // namespace glibra::suite
