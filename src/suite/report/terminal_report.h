#pragma once
// Reports as text: for a terminal, in Markdown, and for JUnit.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "suite/results/results.h"
#include "suite/suite.h"

namespace glibra::suite {

// The report at the end of a run, for a terminal or a log.

struct TextOptions {
    bool color = false;
    std::filesystem::path resultsFolder{};  ///< base of the relative paths of pictures
    int mapColumns = 48;                    ///< characters per row of a heat map, at most; 0: no heat maps
    int mostDetails = 20;                   ///< failures shown with figures, commands and heat map
};

/// Lists every shot that is not a plain pass, the failures last (a terminal shows the end); the warnings of
/// shots that do not fail; and one line with the totals. The first `mostDetails` failures are shown in full,
/// the others with one line each.
std::string toText(const RunResult& run, const TextOptions& options);

// A run as a short Markdown text: for the summary of a CI job, and for a comment on a change.

struct MarkdownOptions {
    std::filesystem::path results;  ///< folder of the run
    /// Where the pictures of the results folder will be found, as "https://host/place"; empty: nowhere, and
    /// small heat maps of characters stand in their place.
    std::string picturesAt{};
};

/// The counts, then a table of the first 30 shots that need a look. No text of a scene can end the table or
/// add markup.
std::string toMarkdown(const RunResult& run, const MarkdownOptions& options);

// JUnit XML, which the test reports of Jenkins, GitLab and GitHub show.

/// Returns one <testsuite> per suite and one <testcase> per shot. A shot without a picture (crashed,
/// timed-out) is an <error>. Other failures are a <failure> whose text has the figures, the paths of the
/// pictures and the commands. Diagnostics of the scene are in <system-out>. If planned shots have no verdict,
/// one more test case is an <error>. The text is UTF-8 and valid XML 1.0 for all strings. Schema:
/// junit-10.xsd of the xUnit plugin of Jenkins.
std::string toJunit(const RunResult& run);

// The commands that a report offers.

/// The command that renders the shot to a file in the current folder.
std::string reproduceCommand(const Shot& shot);
/// The options of pictures that `glibra check` has.
inline constexpr std::array<std::string_view, 13> kCheckOptions{
    "size",   "time",    "steps",           "set",      "eye", "samples", "library", "timeout", "memory",
    "strict", "no-shim", "check-undefined", "check-nan"};
/// The command that answers the checks of the shot's scene; empty if the shot has options that `glibra check`
/// lacks.
std::string checkCommand(const Shot& shot);
/// The command that moves the golden of the shot's former name.
std::string renameCommand(const Suite& suite, const Shot& shot);
/// The command that makes the shot's picture the new golden.
std::string acceptCommand(const Suite& suite, const Shot& shot);

}  // namespace glibra::suite
