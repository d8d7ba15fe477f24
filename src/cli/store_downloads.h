#pragma once
// `glibra test` and goldens whose pictures lie on a web server (suite/golden/picture_store.h): what a run
// downloads, and what is to be uploaded.

#include <filesystem>
#include <functional>
#include <set>
#include <vector>

#include "cli/suite_options.h"
#include "suite/results/results.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::cli {

/// True for a shot whose verdict waits for pictures of the store, in a run that may download them.
bool mayDownload(const suite::ShotResult& shot, const Selection& selection, const suite::RunOptions& options);
/// Downloads the pictures that shots wait for, all of which mayDownload() chose. Returns the shots that have
/// all of theirs now; the others get the reason (suite-E34).
std::set<suite::ShotKey> downloadFor(std::vector<suite::ShotResult>& waiting, const Selection& selection,
                                     const suite::RunOptions& options, const std::function<bool()>& stop);
/// Prints where new pictures are that belong to a web server.
void noteUploads(const std::vector<suite::Suite>& suites, const std::filesystem::path& results);

}  // namespace glibra::cli
