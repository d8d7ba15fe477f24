#pragma once
// The file that a run writes, FOLDER/results.jsonl: one line for the run with what it planned, then one line
// per shot, and at last the line that says that all planned shots have a verdict.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/contained.h"
#include "suite/results/results.h"
#include "system/file.h"

namespace glibra::suite {

/// FOLDER/results.jsonl. The path of a file is the results file itself.
std::filesystem::path resultsFile(const std::filesystem::path& folder);

/// The largest picture of results that is copied or shown.
inline constexpr std::uint64_t kLargestShownPicture = 256ULL << 20;

/// Reads a file that a ShotResult names: a relative path in the results folder, and any path below `roots`,
/// where relative ones start at the current folder. No link is followed. A results file may come from
/// somebody else, so nothing that it names is read in any other way. Errors: file-E01 missing; file-E14
/// outside those folders, a link, a folder, a pipe, a device; file-E09 larger than `largest`.
Result<std::vector<std::byte>> readNamed(const std::filesystem::path& path,
                                         const std::filesystem::path& resultsFolder, const base::Roots& roots,
                                         std::uint64_t largest = kLargestShownPicture);
/// The file-E14 for a file that could not be opened, with the reason in words.
Diagnostic cannotShow(const std::filesystem::path& path, int problem);

/// Writes the whole file, in the order of `run.shots`, with its end line if the run is complete. The file
/// appears when it is whole and on the disk. The folder is made if it does not exist. Returns nothing, or one
/// file-E10.
Diagnostics writeResults(const RunResult& run, const std::filesystem::path& folder);

/// Reads what writeResults or ResultsWriter wrote. The run is complete if the file has its end line. A last
/// line that was torn when its run was killed is left out, with the note result-N01. Of two lines for one
/// shot the later counts, in the place of the earlier. Errors: file-E01, E02, E09, E14 from
/// image::readFile; result-E01 for each broken line (the first 20), for an end line that counts other shots,
/// and for lines after it.
Result<RunResult> readResults(const std::filesystem::path& folder);

/// The lock on a results folder. The process that has taken it has it as long as the object lives; the system
/// releases the lock when the process ends.
using ResultsLock = system::Lock;
/// Makes the folder if it does not exist, and locks it, as a ResultsWriter does. Errors: file-E10; result-E02
/// another process has the lock. Where the file system has no locks, there is a value all the same.
Result<ResultsLock> lockResults(const std::filesystem::path& folder);

/// Appends the shots of a run as they are done. Each line reaches the system in one piece before add()
/// returns, so a run that is killed keeps every result that it has reported. A loss of power costs the
/// results of the last second at most. While a writer lives, no other process can open one on its folder
/// (where the file system has locks).
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

  private:
    ResultsWriter(std::filesystem::path path, ResultsLock lock, system::File file);

    std::filesystem::path path_;
    ResultsLock lock_;
    system::File file_;
    std::chrono::steady_clock::time_point synced_;  ///< when the file was last written to the disk
};

}  // namespace glibra::suite
