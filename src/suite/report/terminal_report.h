#pragma once
// The end of a run in a terminal or a log.

#include <filesystem>
#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

struct TextOptions {
    bool color = false;
    std::filesystem::path resultsFolder{};  ///< that the pictures' paths are relative to
    int mapColumns = 48;                    ///< characters a row of a heat map, at most; 0: no heat maps
    int mostDetails = 20;                   ///< failures told with figures, commands and heat map
};

/// Every shot that is not a plain pass, what needs a look first last of all (a terminal shows the end); the
/// warnings of those that do not fail; then one line that sums up. The first `mostDetails` failures are told
/// in full, others in one line each.
std::string toText(const RunResult& run, const TextOptions& options);
std::string toText(const RunResult& run, bool color, const std::filesystem::path& resultsFolder = {});

}  // namespace glibra::suite
