#pragma once
// What a verdict depends on, as a hash: --resume takes over a verdict only if nothing of it has changed.

#include <map>
#include <optional>
#include <span>
#include <string>

#include "base/workers.h"
#include "suite/results/results.h"
#include "suite/run/read_inputs.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::suite {

/// What the scenes of shots read, and those of the shots that they are compared with. Each scene has the time
/// of its shot, unless `timeout` gives all the same.
using ShotInputs = std::map<ShotReference, SceneInputs>;
ShotInputs inputsOf(std::span<const Suite> suites, std::span<const ShotReference> shots,
                    const base::WorkerOptions& workers, std::optional<double> timeout = {});

/// Hash of the driverKey() of the driver that the workers open; empty if there is none.
std::string keyOfDriver(Driver driver, const base::WorkerOptions& workers);

/// The fingerprints of shots: of the program, the settings of the run, of the shot and of those that it is
/// compared with, the contents of all files that their scenes read with exactly these settings, and of the
/// golden with its variants and its lines in the list of accepted pixels unless the run updates them. Empty
/// for a shot whose scene could not be read. The driver is not part of it: see ShotResult::driverKey.
std::map<ShotReference, std::string> fingerprints(std::span<const Suite> suites,
                                                  std::span<const ShotReference> shots,
                                                  const ShotInputs& inputs, const RunOptions& options);

/// The fingerprint of a shot with its verdict, so that a verdict that somebody has edited does not hold.
/// Empty if the fingerprint is.
std::string sealed(const std::string& fingerprint, Verdict verdict);

}  // namespace glibra::suite
