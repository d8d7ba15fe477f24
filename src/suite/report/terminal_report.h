#pragma once
// The report at the end of a run, for a terminal or a log.

#include <filesystem>
#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

struct TextOptions {
    bool color = false;
    std::filesystem::path resultsFolder{};  ///< base of the relative paths of pictures
    int mapColumns = 48;                    ///< characters per row of a heat map, at most; 0: no heat maps
    int mostDetails = 20;                   ///< failures shown with figures, commands and heat map
};

/// Lists every shot that is not a plain pass, the failures last (a terminal shows the end); the warnings of
/// shots that do not fail; and one line with the totals. The first `mostDetails` failures are shown in full,
/// the others with one line each.
std::string toText(const RunResult& run, const TextOptions& options);

}  // namespace glibra::suite
