#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// The Mandelbrot set by zoom, in float, double, long double and by perturbation, on the CPU and in shaders,
/// against 113 bits of mantissa. Without a driver, the curves of the shaders are missing and gpu-E01 is among
/// the diagnostics.
Result<std::vector<Figure>> measureFractals(Bench& bench);

}  // namespace glibra::bench
