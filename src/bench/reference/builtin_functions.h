#pragma once
// The GLSL functions whose precision is measured: their exact values, their arguments, and the errors that
// the GLSL specification allows (4.60, section 4.7.1 "Range and Precision").

#include <span>
#include <string_view>
#include <vector>

#include "bench/reference/builtin_arguments.h"

namespace glibra::bench {

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
