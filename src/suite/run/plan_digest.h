#pragma once
// What the shards of one run have in common.

#include <span>
#include <string>

#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::suite {

/// Hash of what a run is to judge before it is divided into shards: all shots of `undivided` with their
/// scenes, options, tolerances and pairs, and the settings of the run that decide verdicts. It is the same on
/// every machine: files count by their path from the suite's folder, scenes by their content too. What may
/// differ from machine to machine does not count: the driver, the number of workers, the folders of goldens,
/// results and libraries. The number of shots follows, as in "0f3c...-300".
std::string planDigest(std::span<const Suite> suites, std::span<const ShotReference> undivided,
                       const RunOptions& options);

}  // namespace glibra::suite
