#pragma once
// Which points of a figure are worth their cost.

#include "bench/core/measurement.h"

namespace glibra::bench {

/// True if the cost on a front is the median time, because every point with an error has one. Otherwise the
/// setting is the cost.
bool isTimed(const Figure& figure);

/// Sets Point::isOnFront: no alternative to the point is at least as cheap and as accurate, and better in one
/// of the two. Times are equally cheap if their spreads (25 to 75 %) overlap or they differ by less than 2 %,
/// so that a point that is only a little faster does not excuse a large error. A point without an error is
/// never on a front.
void markFront(Figure& figure);

}  // namespace glibra::bench
