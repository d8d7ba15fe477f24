#pragma once
// The results folder of `glibra test`: filled as shots are done, continued by --resume.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/suite_options.h"
#include "suite/report/report_files.h"
#include "suite/results/results.h"
#include "suite/results/results_file.h"
#include "suite/run/run.h"
#include "suite/run/run_options.h"
#include "suite/suite.h"

namespace glibra::cli {

// What an earlier run left is not taken for the result of this one, even if this one ends before it begins.

/// The files that a run of suites writes at its end; an empty path means that it writes none.
struct ResultFiles {
    std::filesystem::path results;  ///< folder of results.jsonl
    std::filesystem::path report;   ///< folder of index.html
    std::filesystem::path junit;
};

/// Marks the results, the page and the JUnit file that an earlier run has left there as those of a run that
/// did not reach its end: a merge refuses the results, the page says so, and the JUnit file has an error. The
/// shots stay in the results for --resume. Files that no run of suites wrote are left alone, and so are
/// results that another run is writing. Call it before anything can refuse the run.
void markUnfinished(const ResultFiles& files);

// The files that `glibra test` writes beside its results: --report, --junit, --summary.

struct ReportRequest {
    std::string report;      ///< folder of an HTML report
    std::string junit;       ///< file
    std::string summary;     ///< file, Markdown
    std::string picturesAt;  ///< where the pictures of the results will be, for the summary
};

/// Writes those that are asked for. Returns false if one could not be written, which has been printed.
bool writeReports(const suite::RunResult& run, const ReportRequest& request,
                  const std::filesystem::path& results, const suite::ReportRoots& roots);

class RunRecord {
  public:
    /// Waits while another run writes to the folder, until `stop` returns true. Without `resume` the pictures
    /// and results of an earlier run are removed. With `resume` they are kept; the verdicts of a run with
    /// --update count only if this run updates too. Returns nothing if the folder cannot be used; the reason
    /// has been printed.
    static std::optional<RunRecord> open(const std::filesystem::path& folder, const suite::RunResult& run,
                                         bool resume, bool update, const std::function<bool()>& stop);

    /// The earlier run has verdicts that may still hold.
    [[nodiscard]] bool hasEarlier() const { return !results_.empty(); }
    /// What a verdict depends on; empty texts are unknown.
    struct Basis {
        const std::string& fingerprint;
        const std::string& driverKey;  ///< suite::keyOfDriver()
    };
    /// True if the earlier run has a verdict on the shot that still holds, because it depends on just that. A
    /// verdict that does not hold is dropped.
    [[nodiscard]] bool isDone(const suite::Suite& suite, const suite::ShotReference& shot,
                              const Basis& basis);
    /// The number of verdicts that isDone() has dropped.
    [[nodiscard]] std::size_t droppedCount() const { return droppedCount_; }
    void add(const suite::ShotResult& shot);
    /// True once a result could not be written; the reason has been printed.
    [[nodiscard]] bool failed() const { return failed_; }
    /// Puts all results into `run`, in the order of `shots`. Shots without a result are skipped.
    void collect(suite::RunResult& run, std::span<const suite::Suite> suites,
                 std::span<const suite::ShotReference> shots) const;
    /// Writes the run, which is complete if no shot was skipped.
    void finish(suite::RunResult& run);

  private:
    using Key = std::pair<std::string, std::string>;  ///< suite and shot

    RunRecord(std::filesystem::path folder, suite::ResultsWriter writer)
        : folder_(std::move(folder)), writer_(std::move(writer)) {}

    std::filesystem::path folder_;
    suite::ResultsWriter writer_;
    std::map<Key, suite::ShotResult> results_;
    std::size_t droppedCount_ = 0;
    bool failed_ = false;
};

/// True if whoever made one of the suites may have made the results in the folder, too: it lies below that
/// suite's.
bool mayBeForged(const std::filesystem::path& results, std::span<const suite::Suite> suites);

/// True if the golden that an earlier --update made of the shot is gone. `goldens` is as for shownRoots.
bool lacksGolden(const suite::Suite& suite, std::size_t shot, const std::filesystem::path& goldens);

/// The folders whose files a report of these shots may show: the goldens, the suites, their scenes, and what
/// the scenes may read from the library. `goldens` is the folder that replaces those of the suites, or empty.
suite::ReportRoots shownRoots(std::span<const suite::Suite> suites,
                              std::span<const suite::ShotReference> shots,
                              const std::filesystem::path& goldens);

/// The exit status for the verdicts: 0, 1 for a comparison that failed or goldens of no shot that may not be,
/// 3 for a scene that is wrong, crashed or hung.
int exitStatus(const suite::RunResult& run);

// `glibra test` and goldens whose pictures lie on a web server (suite/golden/picture_store.h): what a run
// downloads, and what is to be uploaded.

/// True for a shot whose verdict waits for pictures of the store, in a run that may download them.
bool mayDownload(const suite::ShotResult& shot, const Selection& selection, const suite::RunOptions& options);
/// Downloads the pictures that shots wait for, all of which mayDownload() chose. Returns the shots that have
/// all of theirs now; the others get the reason (suite-E34).
std::set<suite::ShotKey> downloadFor(std::vector<suite::ShotResult>& waiting, const Selection& selection,
                                     const suite::RunOptions& options, const std::function<bool()>& stop);
/// Prints where new pictures are that belong to a web server.
void noteUploads(const std::vector<suite::Suite>& suites, const std::filesystem::path& results);

}  // namespace glibra::cli
