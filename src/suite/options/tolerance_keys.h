#pragma once
// The keys of `tolerance` in a suite, for those who read and those who propose one.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "image/compare/judge.h"

namespace glibra::suite {

struct ToleranceKey {
    std::string_view key;
    double most;  ///< the least is 0
    std::optional<double> (*get)(const image::Tolerance&);
    void (*set)(image::Tolerance&, double);
    bool isWhole = false;
};
std::span<const ToleranceKey> toleranceKeys();

/// "tolerance = { cluster = 12, bias = 1.3 }", a line for the [[shot]]. If the suite states a tolerance for
/// the shot, the line has all its keys, since it takes the place of what the shot has and is merged with
/// [defaults]; otherwise those that differ from the defaults.
std::string toleranceLine(const image::Tolerance& tolerance, bool isStated, bool isFloat);

}  // namespace glibra::suite
