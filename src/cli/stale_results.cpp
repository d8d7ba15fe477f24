#include "cli/stale_results.h"

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

void markResults(const fs::path& folder) {
    std::error_code failure;
    if (!fs::is_regular_file(fs::symlink_status(suite::resultsFile(folder), failure))) return;
    const Result<base::Descriptor> lock = suite::lockResults(folder);
    if (!lock) return;
    Result<suite::RunResult> earlier = suite::readResults(folder);
    if (!earlier || !earlier->complete) return;
    earlier->complete = false;
    print(suite::writeResults(*earlier, folder));
}

}  // namespace

void markUnfinished(const ResultFiles& files) {
    if (!files.results.empty()) markResults(files.results);
    suite::RunResult unfinished;
    unfinished.missingShards = "this run has not reached its end";
    if (!files.junit.empty() && hasMark(files.junit, "<testsuites name=\"glibra\"")) {
        const std::string xml = suite::toJunit(unfinished);
        print(image::writeFileAtomically(files.junit, std::as_bytes(std::span(xml))));
    }
    if (!files.report.empty() && hasMark(files.report / "index.html", "- glibra</title>"))
        print(suite::writeHtmlReport(unfinished, files.results, files.report));
}

}  // namespace glibra::cli
