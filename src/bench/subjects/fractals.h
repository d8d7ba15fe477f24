#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Subject 11: the Mandelbrot set by zoom, in float, double, long double and by perturbation, on the CPU and
/// in shaders, against 113 bits of mantissa. Without a driver the shaders' curves are missing, with gpu-E01
/// among the diagnostics.
Result<std::vector<Figure>> measureFractals(Bench& bench);

}  // namespace glibra::bench
