#pragma once
// A run against an earlier one.

#include <optional>
#include <string>
#include <vector>

#include "bench/core/report.h"

namespace glibra::bench {

struct ComparisonOptions {
    double errorTolerance = .05;         ///< an error may grow by this share
    std::optional<double> timeFactor{};  ///< a median that grew by more is a failure; absent: times only told
};

/// One point that both runs have: the same subject, figure, curve and label.
struct PointChange {
    std::string subject, figure, curve, label, errorUnit;
    double errorBefore = 0, errorNow = 0;  ///< NaN: not measurable
    std::optional<double> timeRatio{};     ///< medians, now over before; absent if one has no time
    bool errorIsWorse = false;             ///< beyond the tolerance, or not measurable any more
    bool errorIsBetter = false;            ///< beyond the tolerance
    bool timeIsWorse = false;              ///< the spreads (25 to 75 %) do not touch and now is slower
    bool timeIsBetter = false;             ///< the same, and now is faster
    bool timeFails = false;                ///< timeIsWorse, and beyond ComparisonOptions::timeFactor
};

struct RunComparison {
    std::vector<PointChange> points;
    std::vector<std::string> missing;  ///< "subject/figure/curve label" of measured subjects, in one run only
    bool sameMachine = true;           ///< processor, cores, renderer and version are the same
};

/// Subjects that only one of them measured are left out; so are missing points if one run was quick.
RunComparison compare(const Report& earlier, const Report& now, const ComparisonOptions& options = {});

/// True if an error got worse or a time fails.
bool isWorse(const RunComparison& comparison);

/// Lines for a terminal: a line on each point that got worse or better, then a summary.
std::string comparisonText(const RunComparison& comparison);

}  // namespace glibra::bench
