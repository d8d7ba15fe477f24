#pragma once
// The file that a run writes, FOLDER/results.jsonl: one line for the run with what it planned, then one line
// per shot, and at last the line that says that all planned shots have a verdict.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <filesystem>

#include "suite/results/results.h"

namespace glibra::suite {

/// FOLDER/results.jsonl. The path of a file is the results file itself.
std::filesystem::path resultsFile(const std::filesystem::path& folder);

/// Where a path of a ShotResult points. Relative paths are searched in the results folder, then from the
/// current folder. If there is no such file, the result is the place in the results folder.
std::filesystem::path located(const std::filesystem::path& path, const std::filesystem::path& resultsFolder);

/// Writes the whole file, in the order of `run.shots`, with its end line if the run is complete. The file
/// appears when it is whole. The folder is made if it does not exist. Returns nothing, or one file-E10.
Diagnostics writeResults(const RunResult& run, const std::filesystem::path& folder);

/// Reads what writeResults or ResultsWriter wrote. The run is complete if the file has its end line. A last
/// line that was torn when its run was killed is left out, with the note result-N01. Of two lines for one
/// shot the later counts, in the place of the earlier. Errors: file-E01, file-E02, file-E09 from
/// image::readFile; result-E01 for each broken line (the first 20), for an end line that counts other shots,
/// and for lines after it.
Result<RunResult> readResults(const std::filesystem::path& folder);

/// Appends the shots of a run as they are done. Each line reaches the system in one piece before add()
/// returns, so a run that is killed keeps every result that it has reported. While a writer lives, no other
/// process can open one on its folder (where the file system has locks).
class ResultsWriter {
  public:
    enum class Start {
        anew,    ///< the file begins with the line of `run` and has no shots
        resumed  ///< the shots of an earlier run stay, after the line of `run`
    };

    /// Makes the folder if it does not exist. `run.shots` is not used. Errors: file-E10; result-E02 another
    /// run is writing to the folder; with `resumed` those of readResults, if there is a file.
    static Result<ResultsWriter> open(const std::filesystem::path& folder, const RunResult& run,
                                      Start start = Start::anew);

    /// Returns nothing, or one file-E10; the file then ends with the line before.
    Diagnostics add(const ShotResult& shot);

    ResultsWriter(ResultsWriter&& other) noexcept;
    ResultsWriter& operator=(ResultsWriter&& other) noexcept;
    ~ResultsWriter();

  private:
    ResultsWriter(std::filesystem::path path, int folder, int file);

    std::filesystem::path path_;
    int folder_ = -1;  ///< has the lock
    int owner_ = 0;    ///< the process that opened it
    int file_ = -1;
};

}  // namespace glibra::suite
