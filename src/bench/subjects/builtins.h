#pragma once
// GLSL functions: their exact values, their arguments, and the errors that the GLSL specification allows
// (4.60, section 4.7.1 "Range and Precision").

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/core/device.h"

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

// The precision of GLSL functions on this driver, measured by running them.

/// The result of one sweep of arguments in one stage. Errors are in units in the last place of the exact
/// result, over all components.
struct Precision {
    double largest = 0;          ///< ULP; infinite if a result is NaN or infinite but the exact one is finite
    double mean = 0;             ///< ULP, of the finite results
    double largestAbsolute = 0;  ///< of the finite results
    std::array<float, 8> worst{};  ///< arguments with the largest error
    std::size_t samples = 0;
    std::size_t notNumbers = 0;  ///< results that are NaN or infinite where the exact one is finite
    /// The largest error as a multiple of what the specification allows; above 1 the bound is broken. Empty
    /// if the specification leaves the precision undefined. 0 / 0 is 0.
    std::optional<double> timesTheBound;
};

/// Compares results (one for each argument set) with the exact values. Results below the smallest normal
/// float may be 0, as the specification allows.
Precision judgePrecision(const BuiltinFunction& function, const ArgumentSweep& sweep,
                         const std::vector<Four>& results);

/// One line of the table.
struct PrecisionRow {
    const BuiltinFunction* function = nullptr;
    const ArgumentSweep* sweep = nullptr;
    Precision vertex, fragment;
};

/// All functions over all their sweeps in both stages, side * side argument sets each.
std::vector<PrecisionRow> precisionTable(Bench& bench, int side = 128);

/// The table as text: one line per sweep, then the bounds of the specification that are broken.
std::string toText(const std::vector<PrecisionRow>& rows);
/// "0.25" or, for two arguments, "0.25, 3": the numbers that the function reads.
std::string argumentsText(const BuiltinFunction& function, const std::array<float, 8>& arguments);

std::vector<Figure> measureBuiltins(Bench& bench);

}  // namespace glibra::bench
