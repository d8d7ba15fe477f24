#pragma once
// A run as a page, whose diagrams are log-log plots in SVG.

#include <span>

#include "bench/report/reports.h"

namespace glibra::bench {

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

/// "0.001", "20", "5000"; beyond 1e-3 .. 1e5 as a power of ten with a raised exponent (an SVG tspan).
std::string tickLabel(double value);

}  // namespace glibra::bench
