#include "cli/stale_results.h"

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/commands.h"
#include "image/file.h"
#include "suite/report/html_report.h"
#include "suite/report/junit_report.h"
#include "suite/results/results_file.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// True if the file is there and has that text in its first kilobytes.
bool hasMark(const fs::path& file, std::string_view mark) {
    constexpr std::uint64_t kLargest = 1ULL << 30;
    constexpr std::size_t kSearched = 4096;
    std::error_code failure;
    if (!fs::is_regular_file(file, failure)) return false;
    const auto bytes = image::readFile(file, {file.string(), {}}, kLargest);
    if (!bytes) return false;
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    return text.substr(0, kSearched).find(mark) != std::string_view::npos;
}

/// Cuts off the line that says that the run is complete. That takes no room on a disk that may be full.
void markResults(const fs::path& folder) {
    const fs::path file = suite::resultsFile(folder);
    std::error_code failure;
    if (!fs::is_regular_file(fs::symlink_status(file, failure))) return;
    const Result<suite::ResultsLock> lock = suite::lockResults(folder);
    if (!lock) return;
    const Result<suite::RunResult> earlier = suite::readResults(folder);
    if (!earlier || !earlier->complete) return;
    const std::size_t cut = suite::endLine(earlier->shots.size()).size() + 1;
    const std::uintmax_t size = fs::file_size(file, failure);
    if (!failure && size > cut) fs::resize_file(file, size - cut, failure);
    if (failure)
        print({diagnose("file-E10", fmt::format("cannot write '{}': {}", file.string(), failure.message()))});
}

/// Prints why a file could not be written, and removes the old one then.
void orRemove(const Diagnostics& problems, const fs::path& old) {
    std::error_code failure;
    if (printErrors(problems)) fs::remove(old, failure);
}

}  // namespace

void markUnfinished(const ResultFiles& files) {
    if (!files.results.empty()) markResults(files.results);
    suite::RunResult unfinished;
    unfinished.missingShards = "this run has not reached its end";
    if (!files.junit.empty() && hasMark(files.junit, "<testsuites name=\"glibra\"")) {
        const std::string xml = suite::toJunit(unfinished);
        orRemove(image::writeFileAtomically(files.junit, std::as_bytes(std::span(xml))), files.junit);
    }
    if (!files.report.empty() && hasMark(files.report / "index.html", "- glibra</title>"))
        orRemove(suite::writeHtmlReport(unfinished, files.results, files.report),
                 files.report / "index.html");
}

}  // namespace glibra::cli
