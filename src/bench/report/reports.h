#pragma once
// What is made of a run: texts, tables and a page.

#include <span>

#include "bench/core/run.h"

namespace glibra::bench {

// A run for a terminal and for spreadsheets, and compared with an earlier one.

/// A subject for a terminal: its figures, one line per curve with both ends of its sweep, and the findings.
/// Ends with a line feed.
std::string textReport(const SubjectRun& subject);

/// "processor, N cores, system; driver" on one line, without a line feed.
std::string machineLine(const Machine& machine);

/// One row per point (RFC 4180, lines end with a line feed) after the header
/// subject,figure,curve,setting,label,error,error_unit,time_median_s,time_low_s,time_high_s,repeats,
/// memory_bytes,front,gpu_time_s.
/// Values that were not measured are empty; front is 0 or 1.
std::string csvReport(const Report& report);

struct ComparisonOptions {
    double errorTolerance = .05;  ///< the share by which an error may grow
    std::optional<double>
        timeFactor{};  ///< the factor by which a median may grow; absent: times are reported but never fail
};

/// One point that is in both runs: same subject, figure, curve and label.
struct PointChange {
    std::string subject, figure, curve, label, errorUnit;
    double errorBefore = 0, errorNow = 0;  ///< NaN: not measurable
    std::optional<double> timeRatio{};     ///< median now / median before; absent if one run has no time
    bool errorIsWorse = false;             ///< beyond the tolerance, or not measurable any more
    bool errorIsBetter = false;            ///< beyond the tolerance
    bool timeIsWorse = false;              ///< slower, and the spreads (25 to 75 %) do not overlap
    bool timeIsBetter = false;             ///< faster, and the spreads do not overlap
    bool timeFails = false;                ///< timeIsWorse, and beyond ComparisonOptions::timeFactor
};

struct RunComparison {
    std::vector<PointChange> points;
    std::vector<std::string>
        missing;  ///< "subject/figure/curve label": points of a measured subject that are in one run only
    bool sameMachine = true;  ///< same processor, cores, renderer and version
};

/// Leaves out subjects that only one run measured. If one run was quick, also leaves out points that only one
/// run has.
RunComparison compare(const Report& earlier, const Report& now, const ComparisonOptions& options = {});

/// True if an error got worse or a time failed.
bool isWorse(const RunComparison& comparison);

/// Lines for a terminal: one line per point that got worse or better, then a summary.
std::string comparisonText(const RunComparison& comparison);

// A run as a page, whose diagrams are log-log plots in SVG.

/// One page that needs no other file and no network: for each figure two diagrams (error against setting and
/// against time), its findings, and a table of all its points. With a comparison, the changes come first.
std::string htmlReport(const Report& report, const RunComparison* comparison = nullptr);

// A logarithmic axis of a diagram: its range, its ticks, and the place of a value.

struct Tick {
    double place = 0;   ///< 0..1 along the axis
    std::string label;  ///< empty for a line without a number
};

class LogAxis {
  public:
    /// Covers the finite values above 0 with a margin; [1, 10] if there are none. A range below 2.5 decades
    /// has ticks at 1, 2 and 5, or at more digits if those are too few. A longer range has ticks at powers of
    /// ten, at most about `mostLabels` of them with a label.
    LogAxis(std::span<const double> values, int mostLabels);

    /// 0..1 for a value in the range; 0 for values at or below 0.
    [[nodiscard]] double place(double value) const;
    [[nodiscard]] const std::vector<Tick>& ticks() const { return ticks_; }

  private:
    void addDecades(int mostLabels);
    void addSteps();
    void addDigits(std::span<const double> digits);

    double low_ = 0, high_ = 1;  ///< decimal logarithms
    std::vector<Tick> ticks_;
};

}  // namespace glibra::bench
