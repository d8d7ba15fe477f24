#pragma once

#include <string>

#include "bench/core/measurement.h"

namespace glibra::bench {

/// One sentence that says what to use: the point with the smallest product of cost and error, with what the
/// most accurate and the cheapest one would give instead. Products within a factor of 1.5 are equal, and the
/// most accurate of equal ones is used, so that the sentence is the same in the next run. Where settings are
/// difficulties (Alternatives::setting), the curve with the smallest geometric mean of the products. Curves
/// that scenes cannot use are left out, and so are wrong answers: angles of more than 5 degrees, and more
/// than 1 of 100 that is wrong (Figure::countsWrong). Empty if nothing is to be chosen.
std::string recommendation(const Figure& figure);

}  // namespace glibra::bench
