#pragma once
// A run as a short Markdown text: for the summary of a CI job, and for a comment on a change.

#include <filesystem>
#include <string>

#include "suite/results/results.h"

namespace glibra::suite {

struct MarkdownOptions {
    std::filesystem::path results;  ///< folder of the run
    /// Where the pictures of the results folder will be found, as "https://host/place"; empty: nowhere, and
    /// small heat maps of characters stand in their place.
    std::string picturesAt{};
};

/// The counts, then a table of the first 30 shots that need a look. No text of a scene can end the table or
/// add markup.
std::string toMarkdown(const RunResult& run, const MarkdownOptions& options);

}  // namespace glibra::suite
