#include "bench/report/log_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glibra::bench {

LogAxis::LogAxis(std::span<const double> values, int mostLabels) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    constexpr double kMargin = .04, kNarrowest = .3, kMostSteps = 2.5;
    low_ = kInfinity;
    high_ = -kInfinity;
    for (const double value : values)
        if (value > 0 && std::isfinite(value)) {
            low_ = std::min(low_, std::log10(value));
            high_ = std::max(high_, std::log10(value));
        }
    if (low_ > high_) low_ = 0, high_ = 1;
    const double lacking = std::max(0., kNarrowest - (high_ - low_));
    const double margin = kMargin * (high_ - low_) + lacking / 2;
    low_ -= margin;
    high_ += margin;
    if (high_ - low_ < kMostSteps)
        addSteps();
    else
        addDecades(mostLabels);
}

double LogAxis::place(double value) const {
    if (!(value > 0)) return 0;
    return std::clamp((std::log10(value) - low_) / (high_ - low_), 0., 1.);
}

void LogAxis::addDecades(int mostLabels) {
    const int first = static_cast<int>(std::ceil(low_)), last = static_cast<int>(std::floor(high_));
    const int every = std::max(1, (last - first + mostLabels) / mostLabels);
    for (int decade = first; decade <= last; ++decade)
        ticks_.push_back({(decade - low_) / (high_ - low_),
                          decade % every == 0 ? tickLabel(std::pow(10., decade)) : std::string()});
}

void LogAxis::addSteps() {
    constexpr std::size_t kFewest = 3;
    addDigits(std::array{1., 2., 5.});
    if (ticks_.size() >= kFewest) return;
    ticks_.clear();
    addDigits(std::array{1., 1.2, 1.5, 2., 3., 4., 5., 7.});
}

void LogAxis::addDigits(std::span<const double> digits) {
    for (int decade = static_cast<int>(std::floor(low_)); decade <= static_cast<int>(std::floor(high_));
         ++decade)
        for (const double digit : digits) {
            const double logarithm = decade + std::log10(digit);
            if (logarithm < low_ || logarithm > high_) continue;
            ticks_.push_back({(logarithm - low_) / (high_ - low_), tickLabel(digit * std::pow(10., decade))});
        }
}

std::string tickLabel(double value) {
    if (value >= .999e-3 && value < 1e5) return fmt::format("{:.6g}", value);
    const int decade = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    const double digit = value / std::pow(10., decade);
    const std::string power = fmt::format("10<tspan class=\"power\" dy=\"-5\">{}</tspan>", decade);
    return std::abs(digit - 1) < 1e-6 ? power : fmt::format("{:.3g}\u00b7{}", digit, power);
}

}  // namespace glibra::bench
