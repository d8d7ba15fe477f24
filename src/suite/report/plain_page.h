#pragma once
// What a browser without scripts shows of a report.

#include <span>
#include <string>

#include "suite/report/report_files.h"
#include "suite/results/results.h"

namespace glibra::suite {

/// HTML for the inside of <noscript>: each shot that is not plain with its pictures, figures, commands and
/// scene, in the order of concern; then the names of the others.
std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                      std::span<const Source> sources);

}  // namespace glibra::suite
