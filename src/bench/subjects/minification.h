#pragma once
// Texture filters against very many samples, and the driver's arithmetic against double.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: a plane in perspective, a surface seen from the front at many distances, magnification.
Result<std::vector<Figure>> measureMinification(Bench& bench);

}  // namespace glibra::bench
