#pragma once
// The part of a report for browsers without scripts.

#include <span>
#include <string>

#include "suite/report/report_files.h"
#include "suite/results/results.h"

namespace glibra::suite {

/// HTML for the inside of <noscript>: every shot that is not a plain pass, with its pictures, figures,
/// commands and scene, the most urgent first; then the names of the others.
std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                      std::span<const Source> sources);

/// The page with `loading="lazy"` removed from its first 24 pictures. Browsers leave grey boxes for pictures
/// that load late in a screenshot without a window and on paper; a page of thousands still opens at once.
std::string loadingFirstScreen(std::string html);

}  // namespace glibra::suite
