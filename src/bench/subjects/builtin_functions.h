#pragma once
// GLSL functions: their exact values, their arguments, and the errors that the GLSL specification allows
// (4.60, section 4.7.1 "Range and Precision").

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
    double setting = 1;  ///< the largest argument, or another number that tells sweeps of a function apart
    std::string words;   ///< "|x| to 10"
    ArgumentRange a{}, b{};
};

/// The distance between floats in the binade of the value, not below 2^-149.
long double unitInLastPlace(long double value);

/// Argument number `index` of a sweep: 0 and 1 are its lower and upper end, the others are a hash of the
/// index.
std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index);

struct BuiltinFunction {
    std::string_view name;        ///< "sin", "atan(y, x)"
    std::string_view group;       ///< functions of one diagram: "trigonometric"
    std::string_view expression;  ///< GLSL over vec4 a, b: "sin(a.x)"
    std::string_view bound;       ///< the specification in words: "2.5 ULP"
    /// The exact result in long double, whose 64 bits leave 40 for the error.
    void (*exact)(const Arguments& arguments, Values& result) = nullptr;
    /// The largest absolute error that the specification allows for component i of the exact result; null if
    /// the precision is undefined. Functions that the specification defines by an equation inherit the errors
    /// of its operations, added up to first order.
    long double (*allowed)(const Arguments& arguments, const Values& exact, int i) = nullptr;
    std::vector<ArgumentSweep> sweeps{};
    int components = 1;  ///< components of the result, 1..3
    /// The period of the result if rounding may move an argument across a border of it (mod); otherwise null.
    long double (*period)(const Arguments& arguments) = nullptr;
};

/// In display order; functions of one group are adjacent.
std::span<const BuiltinFunction> builtinFunctions();

}  // namespace glibra::bench
