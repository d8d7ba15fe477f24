#pragma once
// The results folder of a running test: filled as shots are done, continued by --resume.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "suite/results/results_file.h"
#include "suite/run/run.h"

namespace glibra::cli {

class RunRecord {
  public:
    /// Waits while another run writes to the folder, until `stop` says so. Without `resume` the results of
    /// an earlier run are removed; with it, those of a run with --update count only if this one updates too.
    /// Nothing if it cannot be written; the reason has been printed.
    static std::optional<RunRecord> open(const std::filesystem::path& folder, const suite::RunResult& run,
                                         bool resume, bool update, const std::function<bool()>& stop);

    /// True if the run that is continued has a verdict on it.
    [[nodiscard]] bool isDone(const suite::Suite& suite, const suite::ShotReference& shot) const;
    void add(const suite::ShotResult& shot);
    /// True once a result could not be written; the reason has been printed.
    [[nodiscard]] bool failed() const { return failed_; }
    /// Puts all results into `run`, in the order of `shots` (those without one are skipped), and writes them.
    void finish(suite::RunResult& run, std::span<const suite::Suite> suites,
                std::span<const suite::ShotReference> shots);

  private:
    using Key = std::pair<std::string, std::string>;  ///< suite and shot

    RunRecord(std::filesystem::path folder, suite::ResultsWriter writer)
        : folder_(std::move(folder)), writer_(std::move(writer)) {}

    std::filesystem::path folder_;
    suite::ResultsWriter writer_;
    std::map<Key, suite::ShotResult> results_;
    bool failed_ = false;
};

/// 0, 1 for a comparison that failed, 3 for a scene that is wrong, crashed or hung.
int exitStatus(const suite::RunResult& run);

}  // namespace glibra::cli
