#pragma once
// Orders of convergence, and numbers as words.

#include <limits>
#include <string>
#include <string_view>

#include "bench/core/measurement.h"

namespace glibra::bench {

/// The slope of log(error) over log(setting) by least squares: the order p of error ~ setting^p. Only points
/// with a finite error above 0 and a setting within [from, to] are used; NaN for fewer than two of them.
double fittedOrder(const Curve& curve, double from = 0, double to = std::numeric_limits<double>::infinity());

/// "sphere: error falls as slices^-2.00", "rises as", or "does not depend on" for orders within .05 of 0;
/// "cannot be fitted" if fittedOrder is NaN.
std::string orderSentence(const Curve& curve, std::string_view settingName, double from = 0,
                          double to = std::numeric_limits<double>::infinity());

/// The same for angles in degrees. If all are below 1e-4, which float rounding makes of exact normals:
/// "sphere: within 3e-06 degrees, the rounding of float".
std::string angleSentence(const Curve& degrees, std::string_view settingName, double from = 0);

/// Three significant digits: "0.00123", "1.5e-07"; "not measurable" for NaN.
std::string numberText(double value);
/// "4 ns", "12.3 us", "1.5 ms", "2.1 s"; microseconds with the Greek letter if `greek`.
std::string secondsText(double seconds, bool greek = false);
/// "17 bytes", "2.1 KiB", "300 MiB".
std::string bytesText(double bytes);

}  // namespace glibra::bench
