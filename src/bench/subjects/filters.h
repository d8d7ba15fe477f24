#pragma once
// Image filters, direct and separable, through bytes and floats.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureFilters(Bench& bench);

}  // namespace glibra::bench
