#pragma once
// Subject 13: image filters, direct and separable, through bytes and floats.

#include <vector>

#include "bench/bench.h"
#include "bench/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureFilters(Bench& bench);

}  // namespace glibra::bench
