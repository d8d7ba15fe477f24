#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace glibra::base {

struct WholeNumber {
    double value = 0;    ///< never -0
    bool isCut = false;  ///< a fraction is left out
};

/// The whole number that a number stands for: .6 / .1 is 6, though the quotient of the doubles is below it. A
/// number farther from a whole one than rounding errors reach is cut toward zero.
inline WholeNumber wholeNumber(double value) {
    constexpr double kAbsolute = 1e-9, kRelative = 1e-12;
    const double nearest = std::round(value);
    const bool isNear = std::abs(value - nearest) <= std::max(kAbsolute, kRelative * std::abs(nearest));
    return {(isNear ? nearest : std::trunc(value)) + 0.0, !isNear};
}

/// The whole number, limited to the type's range; NaN becomes 0.
inline std::int32_t toInt(double value) {
    using Limits = std::numeric_limits<std::int32_t>;
    if (value != value) return 0;
    if (value <= static_cast<double>(Limits::min())) return Limits::min();
    if (value >= static_cast<double>(Limits::max())) return Limits::max();
    return static_cast<std::int32_t>(wholeNumber(value).value);
}
inline std::uint32_t toUnsigned(double value) {
    using Limits = std::numeric_limits<std::uint32_t>;
    if (!(value > 0)) return 0;
    if (value >= static_cast<double>(Limits::max())) return Limits::max();
    return static_cast<std::uint32_t>(wholeNumber(value).value);
}

/// Rounds to nearest. Numbers beyond the largest float become infinite, as in GL; a plain conversion would be
/// undefined.
constexpr float toFloat(double value) {
    using Limits = std::numeric_limits<float>;
    // The largest float and half of its last place.
    constexpr double kOverflow = 0x1.ffffffp127;
    if (value >= kOverflow) return Limits::infinity();
    if (value <= -kOverflow) return -Limits::infinity();
    return static_cast<float>(value);
}
/// False for a finite number that no float holds.
inline bool fitsFloat(double value) {
    return !std::isfinite(value) || std::isfinite(toFloat(value));
}

}  // namespace glibra::base
