#pragma once
// What an earlier run left is not taken for the result of this one, even if this one ends before it begins.

#include <filesystem>

namespace glibra::cli {

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

}  // namespace glibra::cli
