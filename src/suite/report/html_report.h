#pragma once
// The report for a browser: a folder that needs no network and no server.

#include <glibra/diagnostic.h>

#include <filesystem>

#include "suite/results/results.h"

namespace glibra::suite {

/// Writes REPORT/index.html, REPORT/pictures (copies; what a browser cannot show, as PNG) and REPORT/pixels
/// (for every shot that is not a plain pass, the values of its pixels as a script, because a page may not
/// read the pixels of picture files). The folder is made if need be; pictures and pixels that an earlier
/// report left there are removed. The page appears last, when all it needs is there.
///
/// The warning result-W02 names a picture or a scene that cannot be read (at most 20 of them); the report
/// says so too. Errors: file-E10.
Diagnostics writeHtmlReport(const RunResult& run, const std::filesystem::path& resultsFolder,
                            const std::filesystem::path& reportFolder);

}  // namespace glibra::suite
