#pragma once
// What `glibra test` does with goldens that belong to no shot.

#include <filesystem>
#include <memory>
#include <vector>

#include "suite/golden/orphans.h"
#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::cli {

/// The goldens that belong to no shot of the suites, for each suite. `goldens` replaces their own folders
/// unless it is empty.
std::vector<std::shared_ptr<const suite::Orphans>> orphansOf(const std::vector<suite::Suite>& suites,
                                                             const std::filesystem::path& goldens);

/// Puts those that are still there into `run`, or removes them with `prune`. Returns the exit status.
int settleOrphans(const std::vector<suite::Suite>& suites,
                  const std::vector<std::shared_ptr<const suite::Orphans>>& orphans, bool prune,
                  suite::RunResult& run);

/// Prints a note about those that the run has left.
void noteOrphans(const suite::RunResult& run);

}  // namespace glibra::cli
