#pragma once
// What became of the shots of a run: the value that every report is made from, and its JSON lines.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/compare/judge.h"

namespace glibra::suite {

enum class Verdict {
    passed,    ///< the picture is the golden one, or within the tolerance; or the expected error came
    failed,    ///< the picture differs, the scene fails, or an expected error did not come
    missing,   ///< there is no golden yet
    unstable,  ///< two renderings on this machine differ
    updated,   ///< --update wrote the golden
    refused,   ///< --update would have written a blank, one-coloured or non-finite picture
    crashed,   ///< the worker that drew it ended
    timedOut,  ///< not drawn within its time
    skipped    ///< not run: another machine's part, or the run was stopped
};

/// All verdicts, in the order of reports: what needs a look first.
inline constexpr Verdict kVerdictsByConcern[] = {Verdict::failed,   Verdict::crashed, Verdict::timedOut,
                                                 Verdict::unstable, Verdict::refused, Verdict::missing,
                                                 Verdict::updated,  Verdict::skipped, Verdict::passed};

/// All words of Verdict: "passed", ..., "timed-out", "skipped".
const char* name(Verdict verdict);
/// The verdict of such a word.
std::optional<Verdict> verdictOf(std::string_view word);
/// True for what makes a run fail (exit status 1): all but passed, updated and skipped.
bool isFailure(Verdict verdict);

/// One shot's outcome. Paths are relative to the results folder unless they are outside of it.
struct ShotResult {
    std::string suite, shot;
    Verdict verdict = Verdict::skipped;
    std::string reason;  ///< one sentence; empty for a plain pass
    std::filesystem::path script;
    std::filesystem::path got, expected, difference;  ///< pictures; empty where there is none
    std::string goldenVariant;  ///< "" for the one for everybody, else "llvmpipe", "nvidia"
    bool exact = false;         ///< decided by the exact hash or equal bytes
    bool changed = false;       ///< passed, but this very driver and processor once gave other bytes
    int width = 0, height = 0;
    image::Judgement judgement;  ///< filled where pictures were compared
    Diagnostics diagnostics;     ///< of the scene
    double milliseconds = 0;     ///< load, draw, read back and compare
    std::string reproduce;       ///< the command line that renders this shot again
    std::string accept;          ///< the command line that makes the picture the new golden
    image::Tolerance tolerance;  ///< that the pictures were judged by
    std::string driver{};        ///< where it is not the run's: runs of several machines joined
};

struct RunResult {
    std::string driver;             ///< GL_RENDERER and GL_VERSION
    std::string machine;            ///< processor model and system
    std::string shard;              ///< "2/8", or empty
    std::string command;            ///< as it was given
    double seconds = 0;             ///< wall time
    std::string began{};            ///< UTC as "2026-01-31T12:00:00Z"; empty if nobody looked
    std::vector<ShotResult> shots;  ///< in the order of the suites
};

/// One line of JSON a shot, without line end. parseJsonLine gives back the same value, whatever bytes the
/// strings hold and also where a figure is no finite number: a string that is not UTF-8 is written as
/// {"bytes": ...} with a character U+0000..U+00FF a byte, a figure that is not finite as "inf", "-inf" or
/// "nan".
std::string toJsonLine(const ShotResult& shot);

/// Reads such a line back. `suite`, `shot` and `verdict` have to be there; other members that are missing
/// keep their defaults, unknown ones are passed over. Errors: result-E01, with `place` moved to the column.
Result<ShotResult> parseJsonLine(std::string_view line, const Place& place);

/// The same for all of a run but its shots: {"run": {...}}.
std::string toJsonLine(const RunResult& run);
Result<RunResult> parseRunLine(std::string_view line, const Place& place);

}  // namespace glibra::suite
