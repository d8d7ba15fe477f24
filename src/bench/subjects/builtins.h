#pragma once
// The precision of GLSL functions on this driver, measured by running them.

#include <array>
#include <optional>
#include <string>

#include "bench/core/device.h"
#include "bench/subjects/builtin_functions.h"

namespace glibra::bench {

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
