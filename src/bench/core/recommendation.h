#pragma once

#include <string>

#include "bench/core/measurement.h"

namespace glibra::bench {

/// One sentence that says what to use, for a figure whose fronts are marked: the point of a front with the
/// smallest product of cost and error, with what the most accurate and the cheapest one would give instead.
/// Where settings are difficulties (Alternatives::setting), the curve that is on most fronts. Empty if
/// nothing is to be chosen.
std::string recommendation(const Figure& figure);

}  // namespace glibra::bench
