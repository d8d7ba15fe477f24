#pragma once

#include <cstdint>
#include <limits>

namespace glibra::base {

/// Truncates and limits to the type's range; NaN becomes 0.
constexpr std::int32_t toInt(double value) {
    using Limits = std::numeric_limits<std::int32_t>;
    if (value != value) return 0;
    if (value <= static_cast<double>(Limits::min())) return Limits::min();
    if (value >= static_cast<double>(Limits::max())) return Limits::max();
    return static_cast<std::int32_t>(value);
}
constexpr std::uint32_t toUnsigned(double value) {
    using Limits = std::numeric_limits<std::uint32_t>;
    if (!(value > 0)) return 0;
    if (value >= static_cast<double>(Limits::max())) return Limits::max();
    return static_cast<std::uint32_t>(value);
}

/// Rounds to nearest. Numbers beyond the largest float become infinite, as in GL; a plain conversion would be
/// undefined.
constexpr float toFloat(double value) {
    using Limits = std::numeric_limits<float>;
    // Half a unit in the last place above the largest float still rounds down to it.
    constexpr double kOverflow = static_cast<double>(Limits::max()) * (1 + 0x1p-25);
    if (value >= kOverflow) return Limits::infinity();
    if (value <= -kOverflow) return -Limits::infinity();
    return static_cast<float>(value);
}

}  // namespace glibra::base
