#pragma once
// Folders that are not there.

#include <filesystem>
#include <string>

namespace glibra::suite {

/// "there is no folder 'a/strat'; did you mean 'start'?" for the first part of `folder` that is no folder,
/// the question only if a folder beside it has a name near to that. Empty if `folder` is there.
std::string whyNoFolder(const std::filesystem::path& folder);

}  // namespace glibra::suite
