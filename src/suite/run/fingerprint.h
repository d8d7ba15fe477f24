#pragma once
// What a verdict depends on, as a hash: --resume takes over a verdict only if nothing of it has changed.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/workers.h"
#include "suite/results/results.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::suite {

// What the shards of one run have in common.

/// Hash of what a run is to judge before it is divided into shards: all shots of `undivided` with their
/// scenes, options, tolerances and pairs, and the settings of the run that decide verdicts. It is the same on
/// every machine: files count by their path from the suite's folder, scenes by their content too. What may
/// differ from machine to machine does not count: the driver, the number of workers, the folders of goldens,
/// results and libraries. The number of shots follows, as in "0f3c...-300".
std::string planDigest(std::span<const Suite> suites, std::span<const ShotReference> undivided,
                       const RunOptions& options);

// What scenes read, found out in worker processes, since a scene may have been written by somebody else.

struct SceneQuery {
    std::filesystem::path scene;
    RenderOptions options;
    std::optional<double> timeout{};  ///< seconds, instead of those of the workers; 0: no limit
};

struct SceneInputs {
    std::vector<std::filesystem::path> files;  ///< render::filesReadBy()
    /// Hash of their names and contents; empty if they could not be read or there may be more.
    std::string content;
};

/// The inputs of each scene with exactly its options, in the order of the queries. Equal queries are answered
/// once. A scene whose worker ends or is late has none, and takes no other's.
std::vector<SceneInputs> readInputs(std::span<const SceneQuery> queries, const base::WorkerOptions& options);

/// Hash of a file's content as text; the reason as a word if it cannot be read.
std::string contentOf(const std::filesystem::path& file);

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
