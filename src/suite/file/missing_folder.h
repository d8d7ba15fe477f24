#pragma once
// Messages about folders that do not exist.

#include <filesystem>
#include <string>

namespace glibra::suite {

/// Names the first part of `folder` that is not a folder: "there is no folder 'a/strat'; did you mean
/// 'start'?". The question is left out if no folder beside it has a similar name. Empty if `folder` exists.
std::string whyNoFolder(const std::filesystem::path& folder);

}  // namespace glibra::suite
