#pragma once
// Subject 8: lighting by vertex and by fragment against the analytic surface.

#include <vector>

#include "bench/bench.h"
#include "bench/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureLighting(Bench& bench);

}  // namespace glibra::bench
