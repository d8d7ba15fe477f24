#pragma once
// --max-error over the scenes that ship: whether its bound holds, and what it costs beside the default and
// beside one fineness for all.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"
#include "image/image.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureBudget(Bench& bench);

/// How far what one picture shows lies beside its place in the other, in pixels: the smallest radius r, 0 to
/// `most`, such that all but one of 1000 pixels of either have values that the other has within r pixels
/// around the same place, between the smallest and the largest there, to within 8/255. Both RGB or RGBA bytes
/// of one size. `most` + 1 if no such radius is found.
int displacement(const image::Image& a, const image::Image& b, int most);

}  // namespace glibra::bench
