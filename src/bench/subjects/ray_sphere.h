#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Subject 12: where a ray of floats meets a unit sphere, by the textbook's formula and stable ones, by
/// distance, and for rays that graze it; against 100 digits. Without a driver the shaders' curves are
/// missing, with gpu-E01 among the diagnostics.
Result<std::vector<Figure>> measureRaySphere(Bench& bench);

}  // namespace glibra::bench
