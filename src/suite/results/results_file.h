#pragma once
// The file a run leaves behind, FOLDER/results.jsonl: the run in the first line, then a line a shot.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <filesystem>

#include "suite/results/results.h"

namespace glibra::suite {

/// FOLDER/results.jsonl; a path that is no folder but a file is the results file itself.
std::filesystem::path resultsFile(const std::filesystem::path& folder);

/// Where a path of a ShotResult is: relative ones are looked for in the results folder, then from the current
/// folder. Gives the place in the results folder where there is no such file.
std::filesystem::path located(const std::filesystem::path& path, const std::filesystem::path& resultsFolder);

/// Writes the whole file, in the order of `run.shots`; it appears when it is whole. The folder is made if
/// need be. Empty if that worked, else one file-E10.
Diagnostics writeResults(const RunResult& run, const std::filesystem::path& folder);

/// Reads what writeResults or ResultsWriter wrote. A last line that was torn when its run was killed is left
/// out, with the note result-N01; of two lines for one shot the later counts, in the earlier's place. Errors:
/// file-E01, file-E02, file-E09 as image::readFile gives them, result-E01 for each broken line (the first
/// 20).
Result<RunResult> readResults(const std::filesystem::path& folder);

/// Appends the shots of a run as they are done. Each line reaches the system in one piece before add()
/// returns, so that a run that is killed loses nothing it has told. While a writer lives, no other process
/// can open one on its folder (where the file system has locks).
class ResultsWriter {
  public:
    enum class Start {
        anew,    ///< the file begins with `run`'s line and no shots
        resumed  ///< lines that are there stay, but a torn one is cut off; without a file: anew
    };

    /// Makes the folder if need be; of `run` only what is not `shots` is used. Errors: file-E10;
    /// result-E02 another run is writing to the folder.
    static Result<ResultsWriter> open(const std::filesystem::path& folder, const RunResult& run,
                                      Start start = Start::anew);

    /// Empty if that worked, else one file-E10, and the file ends with the line before.
    Diagnostics add(const ShotResult& shot);

    ResultsWriter(ResultsWriter&& other) noexcept;
    ResultsWriter& operator=(ResultsWriter&& other) noexcept;
    ~ResultsWriter();

  private:
    ResultsWriter(std::filesystem::path path, int folder, int file);

    std::filesystem::path path_;
    int folder_ = -1;  ///< holds the lock
    int owner_ = 0;    ///< the process that opened it
    int file_ = -1;
};

}  // namespace glibra::suite
