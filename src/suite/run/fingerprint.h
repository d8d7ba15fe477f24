#pragma once
// What a verdict depends on, as a hash: --resume takes over a verdict only if nothing of it has changed.

#include <map>
#include <span>
#include <string>

#include "base/workers.h"
#include "suite/run/read_inputs.h"
#include "suite/run/run.h"
#include "suite/suite.h"

namespace glibra::suite {

/// What the scenes of shots read, and those of the shots that they are compared with.
using ShotInputs = std::map<ShotReference, SceneInputs>;
ShotInputs inputsOf(std::span<const Suite> suites, std::span<const ShotReference> shots,
                    const base::WorkerOptions& workers);

/// The fingerprints of shots: of the program, the settings of the shot and of those that it is compared with,
/// the contents of all files that their scenes read, and of the golden with its variants unless the run
/// updates it. Empty for a shot whose scene could not be read.
std::map<ShotReference, std::string> fingerprints(std::span<const Suite> suites,
                                                  std::span<const ShotReference> shots,
                                                  const ShotInputs& inputs, const RunOptions& options);

}  // namespace glibra::suite
