#pragma once
// Lighting per vertex and per fragment against the analytic surface.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureLighting(Bench& bench);

}  // namespace glibra::bench
