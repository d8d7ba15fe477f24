#include "bench/reference/builtin_arguments.h"

#include <algorithm>
#include <cmath>

namespace glibra::bench {
namespace {

/// A number in 0 <= u < 1 computed from the two arguments (finaliser of MurmurHash3 by Austin Appleby).
double uniform(std::uint32_t index, std::uint32_t slot) {
    std::uint64_t h = (std::uint64_t{index} << 8 | slot) + 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDULL;
    h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53ULL;
    h ^= h >> 33;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

float within(const ArgumentRange& range, double u) {
    const auto at = [&](double t) {
        const double value = range.byMagnitude ? range.low * std::pow(range.high / range.low, t)
                                               : std::lerp(range.low, range.high, t);
        return static_cast<float>(std::clamp(value, range.low, range.high));
    };
    if (!range.bothSigns) return at(u);
    return u < .5 ? -at(1 - 2 * u) : at(2 * u - 1);
}

}  // namespace

long double unitInLastPlace(long double value) {
    constexpr int kLowestExponent = -126;  // of normal floats
    if (value == 0) return 0x1p-149L;
    return std::ldexp(1.0L, std::max(std::ilogb(value), kLowestExponent) - 23);
}

std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index) {
    std::array<float, 8> arguments{};
    for (std::uint32_t slot = 0; slot < 8; ++slot) {
        const double u = index == 0 ? 0 : index == 1 ? 1 : uniform(index, slot);
        arguments[slot] = within(slot < 4 ? sweep.a : sweep.b, u);
    }
    return arguments;
}

}  // namespace glibra::bench
