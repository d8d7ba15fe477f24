#pragma once
// What `glibra test` says about goldens that belong to no shot.

#include <filesystem>
#include <vector>

#include "suite/suite.h"

namespace glibra::cli {

/// Lists the goldens that belong to no shot of the suites, or removes them. `goldens` replaces their own
/// folders unless it is empty. Returns the exit status.
int answerOrphans(const std::vector<suite::Suite>& suites, const std::filesystem::path& goldens, bool prune);

}  // namespace glibra::cli
