#pragma once
// The arguments with which GLSL functions are measured.

#include <array>
#include <cstdint>
#include <string>

namespace glibra::bench {

/// a.x a.y a.z a.w b.x b.y b.z b.w: exactly the floats that the shader gets.
using Arguments = std::array<long double, 8>;
using Values = std::array<long double, 4>;

/// The values of one component of an argument.
struct ArgumentRange {
    double low = 0, high = 1;
    bool byMagnitude = false;  ///< spread over the orders of magnitude from low > 0, otherwise evenly
    bool bothSigns = false;    ///< also the negative values
};

/// One point of a function's curve.
struct ArgumentSweep {
    double setting =
        1;  ///< the largest argument, or another number that distinguishes the sweeps of a function
    std::string words;  ///< "|x| to 10"
    ArgumentRange a{}, b{};
};

/// The distance between floats in the binade of the value, not below 2^-149.
long double unitInLastPlace(long double value);

/// Argument number `index` of a sweep: 0 and 1 are its lower and upper end, the others are a hash of the
/// index.
std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index);

}  // namespace glibra::bench
