#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Position, normal, outline and volume of the solids against closed forms, by slices and stacks; teapot and
/// soccer ball; a sphere as the driver draws it. Without a driver, the last figure is missing and gpu-E01 is
/// among the diagnostics.
Result<std::vector<Figure>> measurePrimitives(Bench& bench);

}  // namespace glibra::bench
