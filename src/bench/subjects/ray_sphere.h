#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// The intersection of rays in float with a unit sphere, by the textbook formula and by stable ones, by
/// distance and for rays that graze it; against 100 digits. Without a driver, the curves of the shaders are
/// missing and gpu-E01 is among the diagnostics.
Result<std::vector<Figure>> measureRaySphere(Bench& bench);

}  // namespace glibra::bench
