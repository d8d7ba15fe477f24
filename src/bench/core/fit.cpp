#include "bench/core/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glibra::bench {

double fittedOrder(const Curve& curve, double from, double to) {
    double count = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
    for (const Point& point : curve.points) {
        if (!(point.error > 0) || std::isinf(point.error) || !(point.setting > 0)) continue;
        if (point.setting < from || point.setting > to) continue;
        const double x = std::log(point.setting), y = std::log(point.error);
        count += 1;
        sumX += x;
        sumY += y;
        sumXX += x * x;
        sumXY += x * y;
    }
    const double spread = count * sumXX - sumX * sumX;
    if (count < 2 || !(spread > 0)) return std::numeric_limits<double>::quiet_NaN();
    return (count * sumXY - sumX * sumY) / spread;
}

std::string orderSentence(const Curve& curve, std::string_view settingName, double from, double to) {
    constexpr double kFlat = .05;
    const double order = fittedOrder(curve, from, to);
    if (std::isnan(order)) return fmt::format("{}: the order of the error cannot be fitted", curve.name);
    if (std::abs(order) < kFlat)
        return fmt::format("{}: error does not depend on {}", curve.name, settingName);
    return fmt::format("{}: error {} as {}^{:.2f}", curve.name, order < 0 ? "falls" : "rises", settingName,
                       order);
}

std::string angleSentence(const Curve& degrees, std::string_view settingName, double from) {
    constexpr double kRounding = 1e-4;
    double largest = 0;
    for (const Point& each : degrees.points) largest = std::max(largest, each.error);
    if (largest >= kRounding) return orderSentence(degrees, settingName, from);
    return fmt::format("{}: within {} degrees, the rounding of float", degrees.name, numberText(largest));
}

std::string numberText(double value) {
    return std::isnan(value) ? "not measurable" : fmt::format("{:.3g}", value);
}

std::string secondsText(double seconds, bool greek) {
    if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
    if (seconds < 1e-3) return fmt::format("{:.3g} {}s", seconds * 1e6, greek ? "\u00b5" : "u");
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}

std::string bytesText(double bytes) {
    constexpr double kStep = 1024;
    if (bytes < kStep) return fmt::format("{:.0f} bytes", bytes);
    for (const char* unit : {"KiB", "MiB"}) {
        bytes /= kStep;
        if (bytes < kStep) return fmt::format("{:.3g} {}", bytes, unit);
    }
    return fmt::format("{:.3g} GiB", bytes / kStep);
}

}  // namespace glibra::bench
