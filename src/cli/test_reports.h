#pragma once
// The files that `glibra test` writes beside its results: --report, --junit, --summary.

#include <filesystem>
#include <string>

#include "suite/report/report_files.h"
#include "suite/results/results.h"

namespace glibra::cli {

struct ReportRequest {
    std::string report;      ///< folder of an HTML report
    std::string junit;       ///< file
    std::string summary;     ///< file, Markdown
    std::string picturesAt;  ///< where the pictures of the results will be, for the summary
};

/// Writes those that are asked for. Returns false if one could not be written, which has been printed.
bool writeReports(const suite::RunResult& run, const ReportRequest& request,
                  const std::filesystem::path& results, const suite::ReportRoots& roots);

}  // namespace glibra::cli
