#pragma once
// The functions of GLSL whose precision is measured: what they are exactly, over which arguments, and what
// the GLSL specification allows (4.60, section 4.7.1 "Range and Precision").

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::bench {

/// a.x a.y a.z a.w b.x b.y b.z b.w, exactly the floats that the shader gets.
using Arguments = std::array<long double, 8>;
using Values = std::array<long double, 4>;

/// The numbers that a component of an argument takes.
struct ArgumentRange {
    double low = 0, high = 1;
    bool byMagnitude = false;  ///< spread over the orders of magnitude from low > 0 on, else evenly
    bool bothSigns = false;    ///< and the same below 0
};

/// One point of a function's curve.
struct ArgumentSweep {
    double setting = 1;  ///< the largest argument, or what else tells the sweeps of a function apart
    std::string words;   ///< "|x| to 10"
    ArgumentRange a{}, b{};
};

struct BuiltinFunction {
    std::string_view name;        ///< "sin", "atan(y, x)"
    std::string_view group;       ///< functions of one diagram: "trigonometric"
    std::string_view expression;  ///< GLSL over vec4 a, b: "sin(a.x)"
    int components = 1;           ///< of the result, 1..3
    std::string_view bound;       ///< the specification in words: "2.5 ULP"
    /// In long double, whose 64 bits leave 40 for the error.
    void (*exact)(const Arguments& arguments, Values& result) = nullptr;
    /// Largest absolute error that the specification allows for component i of the exact result; null where
    /// it leaves the precision open. Functions given by an equation inherit the errors of its operations,
    /// added up to first order.
    long double (*allowed)(const Arguments& arguments, const Values& exact, int i) = nullptr;
    /// The period of the result, if an argument at a border may fall to either side of it (mod); else null.
    long double (*period)(const Arguments& arguments) = nullptr;
    std::vector<ArgumentSweep> sweeps{};
};

/// In the order in which they are shown, those of a group together.
std::span<const BuiltinFunction> builtinFunctions();

/// The distance between floats at that value: of the binade it lies in, not below 2^-149.
long double unitInLastPlace(long double value);

/// Arguments number `index` of a sweep: 0 and 1 are its lower and upper end, the others a hash of the index.
std::array<float, 8> argumentsOf(const ArgumentSweep& sweep, std::uint32_t index);

}  // namespace glibra::bench
