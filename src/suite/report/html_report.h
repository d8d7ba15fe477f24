#pragma once
// The report for a browser: a folder that needs neither network nor server.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <span>
#include <string>

#include "suite/report/report_files.h"
#include "suite/results/results.h"

namespace glibra::suite {

// The part of a report for browsers without scripts.

/// HTML for the inside of <noscript>: every shot that is not a plain pass, with its pictures, figures,
/// commands and scene, the most urgent first; then the names of the others.
std::string plainPage(const RunResult& run, std::span<const ShownShot> shown,
                      std::span<const Source> sources);

/// The page with `loading="lazy"` removed from its first 24 pictures. Browsers leave grey boxes for pictures
/// that load late in a screenshot without a window and on paper; a page of thousands still opens at once.
std::string loadingFirstScreen(std::string html);

/// Writes REPORT/index.html, REPORT/pictures (copies, as PNG where a browser cannot show the format) and
/// REPORT/pixels. The latter has, for every shot that is not a plain pass, the values of its pixels as a
/// script, because a page may not read the pixels of picture files. The folder is made if it does not exist.
/// Pictures and pixels of an earlier report are removed. The page is written last, when everything that it
/// needs exists.
///
/// The report shows files of the results folder, and what lies below `roots`: scenes, shaders,
/// goldens. No link is followed, and no other file is read, whatever the results name.
///
/// The warning result-W02 names a picture or a scene that cannot be read (at most 20 of them); the report
/// mentions it too. Errors: file-E10.
Diagnostics writeHtmlReport(const RunResult& run, const std::filesystem::path& resultsFolder,
                            const std::filesystem::path& reportFolder, const ReportRoots& roots = {});

}  // namespace glibra::suite
