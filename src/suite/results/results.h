#pragma once
// The results of a run, from which every report is made, and their JSON lines.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <compare>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/compare/judge.h"

namespace glibra::suite {

enum class Verdict {
    passed,    ///< the picture is equal to the golden or within the tolerance; or the expected error occurred
    failed,    ///< the picture differs, the scene has errors, or an expected error did not occur
    missing,   ///< there is no golden yet
    unstable,  ///< two renderings on this machine differ
    updated,   ///< --update wrote the golden
    refused,   ///< --update would have written a blank, one-coloured or non-finite picture
    crashed,   ///< the worker process that drew it ended
    timedOut,  ///< not drawn within its time
    flaky,     ///< one of its drawings was right, others were not (`retries`)
    quarantined,  ///< it failed on a day of its quarantine
    skipped       ///< not run, because the run was stopped
};

/// All verdicts in the order of reports, the most urgent first.
inline constexpr Verdict kVerdictsByConcern[] = {Verdict::failed,   Verdict::crashed,     Verdict::timedOut,
                                                 Verdict::unstable, Verdict::refused,     Verdict::missing,
                                                 Verdict::flaky,    Verdict::quarantined, Verdict::updated,
                                                 Verdict::skipped,  Verdict::passed};

/// All words of Verdict: "passed", ..., "timed-out", "skipped".
const char* name(Verdict verdict);
/// A sentence for a shot without a reason; empty for a pass.
const char* meaning(Verdict verdict);
/// The verdict of such a word, or nothing.
std::optional<Verdict> verdictOf(std::string_view word);
/// True for verdicts that make a run fail (exit status 1): all but passed, updated, flaky, quarantined and
/// skipped.
bool isFailure(Verdict verdict);

/// The result of one shot. Paths are relative to the results folder unless they are outside of it.
struct ShotResult {
    std::string suite, shot;
    Verdict verdict = Verdict::skipped;
    std::string reason;  ///< one sentence; empty for a plain pass
    std::filesystem::path script;
    std::filesystem::path got, expected, difference;  ///< pictures; empty if there is none
    std::string goldenVariant;  ///< "llvmpipe", "nvidia"; empty for the golden for all drivers
    bool exact = false;         ///< all pixels are equal to those of the golden
    bool changed = false;       ///< passed, but the same driver and processor gave other bytes before
    double compared = 1;        ///< the part of the picture that `ignore` and `mask` leave to be compared
    std::filesystem::path renamedFrom{};  ///< a golden of no shot with the same pixels, for a missing one
    std::filesystem::path nearTo{};  ///< or one that may be of this shot before it was renamed and changed
    int width = 0, height = 0;
    image::Judgement judgement;      ///< set if pictures were compared
    Diagnostics diagnostics;         ///< messages about the scene
    double milliseconds = 0;         ///< load, draw, read back and compare
    std::string reproduce;           ///< the command line that renders this shot again
    std::string accept;              ///< the command line that makes the picture the new golden
    image::Tolerance tolerance;      ///< the tolerance that was applied
    image::DifferenceSteps steps{};  ///< how many pixels differ by more than what, if the picture fails
    /// A line for its [[shot]] that would just pass the picture, as "tolerance = { cluster = 12 }"; or why no
    /// tolerance is sensible. Both are empty where a tolerance decides nothing.
    std::string toPass{}, noTolerance{};
    std::string fingerprint{};  ///< of what the verdict depends on (fingerprint.h); empty if unknown
    std::string driverKey{};    ///< hash of the driverKey() of the driver that drew it; empty if unknown
    std::string driver{};       ///< if it differs from the driver of the run, as in merged runs
    std::vector<std::filesystem::path> reads{};  ///< the files that its scene reads, if it needs a look
    /// The goldens whose pictures this machine lacks and without which the verdict is not final, and whether
    /// they lie in the store of the suite.
    std::vector<std::filesystem::path> awaits{};
    bool awaitsStore = false;
    /// The driverKey() itself, if `got` may become a golden, for its line in the list of hashes.
    std::string acceptKey{};
};

/// True for a shot that failed without a picture: its scene has errors, or the process that drew it ended.
bool wasNotDrawn(const ShotResult& shot);
/// True for a pass whose picture is not the one that this driver and processor gave before.
bool isChangedPass(const ShotResult& shot);
/// True for a shot that somebody should look at: a failure, one that does not count as such, and a changed
/// pass.
bool needsALook(const ShotResult& shot);
/// Makes the result that of a flaky shot: drawing number `drawing` is right, and one before had the verdict
/// of `before`, which may be the result itself.
void makeFlaky(ShotResult& shot, int drawing, const ShotResult& before);
/// With --strict-flaky: a flaky shot is unstable, which is a failure.
void countFlakyAsFailure(ShotResult& shot);

/// Shots of one suite that a run was to judge.
struct PlannedShots {
    std::string suite;
    std::vector<std::string> shots;
    std::string file{};  ///< the suite's file as the run named it; empty if unknown
    friend bool operator==(const PlannedShots&, const PlannedShots&) = default;
};

/// A golden that belongs to no shot of its suite.
struct OrphanGolden {
    std::string suite, file;
    friend auto operator<=>(const OrphanGolden&, const OrphanGolden&) = default;
};

struct RunResult {
    std::string driver;             ///< GL_RENDERER and GL_VERSION
    std::string machine;            ///< processor model and system
    std::string shard;              ///< "2/8", or empty
    std::string plan{};             ///< planDigest(), the same for all shards of a run; empty if unknown
    std::string command;            ///< the command line
    double seconds = 0;             ///< wall time
    std::string began{};            ///< UTC as "2026-01-31T12:00:00Z"; empty if unknown
    std::vector<ShotResult> shots;  ///< in the order of the suites
    /// What the run set out to judge; nothing for a value that no run wrote.
    std::optional<std::vector<PlannedShots>> planned{};
    /// "2 of 4 shards are missing: 2/4, 4/4", or what else makes a merged run no whole; empty if it is one.
    std::string missingShards{};
    std::vector<OrphanGolden> orphans{};  ///< that the run has left, sorted
    bool orphansFail = false;             ///< they make the run fail; no part of the results
    bool complete = false;                ///< the run reached its end, with a verdict on every planned shot
};

/// A shot's suite and name.
using ShotKey = std::pair<std::string, std::string>;
/// The planned shots without a verdict (or skipped), in their order; empty if no plan is known.
std::vector<ShotKey> missingShots(const RunResult& run);
/// "2 of 8 planned shots have no verdict: s/a, s/b", after the missing shards; empty if nothing is missing or
/// no plan is known.
std::string shortfall(const RunResult& run);
/// The same sentence for shots that were found to be missing.
std::string shortfall(const std::vector<ShotKey>& missing, std::size_t planned);
/// "2 goldens of no shot of 's' (--prune removes them): golden/a.png golden/b.png": a line for each suite
/// that has some, with the first `most` names.
std::vector<std::string> orphanLines(const RunResult& run, std::size_t most);
/// What brings the pictures of all goldens that a run lacks and that lie in no store: a command of Git LFS,
/// with the number of goldens; empty if it lacks none.
std::string awaitedLine(const RunResult& run);
/// The number of planned shots.
std::size_t plannedCount(const RunResult& run);

/// One line of JSON for a shot, without its line end. parseJsonLine gives back the same value for any bytes
/// in the strings and any figures. A string that is not UTF-8 is written as {"bytes": ...} with one character
/// U+0000..U+00FF per byte; a number that is not finite is written as "inf", "-inf" or "nan".
std::string toJsonLine(const ShotResult& shot);

/// Reads such a line. `suite`, `shot` and `verdict` are required. Other members that are missing keep their
/// defaults; unknown members are ignored. Error: result-E01 at `place`, also for a time, a size or a line
/// number that no run writes.
Result<ShotResult> parseJsonLine(std::string_view line, const Place& place);

/// The same for a run without its shots and its end: {"run": {...}}.
std::string toJsonLine(const RunResult& run);
Result<RunResult> parseRunLine(std::string_view line, const Place& place);

/// The line that ends the results of a run that is complete: {"end": {"shots": 8}}.
std::string endLine(std::size_t shots);
/// The number of shots in such a line; nothing if it is another line.
std::optional<std::size_t> parseEndLine(std::string_view line);

// The figures of a comparison as lines of text. All reports print these.

struct Figure {
    std::string name;   ///< "largest difference"
    std::string value;  ///< "12/255 (red, at 40 12)"
    std::string limit;  ///< "3/255"; or empty
    bool beyond = false;
};

/// The figures of a shot: how much of its picture is compared, unless it is all, and those of the comparison,
/// unless no pictures were compared (equal bytes, different sizes, a shot without a picture).
std::vector<Figure> figures(const ShotResult& shot);

/// How many pixels differ by more than each step, as "0: 5120, 1: 2210, 2: 96, 4: 12, 8: 0 of 255"; empty if
/// unknown.
std::string stepsText(const ShotResult& shot);

/// What decided: "equal bytes", "largest difference", ...; empty if nothing was compared.
std::string decision(const ShotResult& shot);

/// What the two pictures of a shot are: "expected" and "got"; of an unstable one, its two drawings.
struct PictureTitles {
    const char* expected;
    const char* got;
};
PictureTitles titlesOf(const ShotResult& shot);

/// The sentence to show for a shot: its reason, or the meaning of the verdict if it has none.
std::string reasonOf(const ShotResult& shot);

/// "30 drawn, 10 failed, none has a golden yet", "1 drawn without a golden, 3 failed, 120 passed": the
/// verdicts that occur, the most urgent first after the pictures that have no golden yet; "no shots" if there
/// are none.
std::string counts(const RunResult& run);

/// "0.2 s", "48 s", "2 min 5 s", "1 h 3 min".
std::string readableTime(double seconds);

}  // namespace glibra::suite
