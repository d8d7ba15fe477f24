#include "cli/test_reports.h"

#include <span>
#include <system_error>

#include "cli/commands.h"
#include "image/file.h"
#include "suite/report/html_report.h"
#include "suite/report/junit_report.h"
#include "suite/report/markdown_report.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

Diagnostics writeText(const std::string& file, const std::string& text) {
    std::error_code ignored;  // reported with the file that cannot be written
    if (const fs::path folder = fs::path(file).parent_path(); !folder.empty())
        fs::create_directories(folder, ignored);
    return image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}  // namespace

bool writeReports(const suite::RunResult& run, const ReportRequest& request, const fs::path& results,
                  const suite::ReportRoots& roots) {
    Diagnostics problems;
    if (!request.report.empty()) {
        append(problems, suite::writeHtmlReport(run, results, request.report, roots));
        if (!hasError(problems)) printLine("report: " + (fs::path(request.report) / "index.html").string());
    }
    if (!request.junit.empty()) append(problems, writeText(request.junit, suite::toJunit(run)));
    if (!request.summary.empty())
        append(problems,
               writeText(request.summary,
                         suite::toMarkdown(run, {.results = results, .picturesAt = request.picturesAt})));
    return !printErrors(problems);
}

}  // namespace glibra::cli
