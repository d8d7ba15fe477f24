#pragma once
// Depth buffers: the smallest gap between two surfaces that is resolved.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: gap against far / near at the far end, gap against distance, share of fighting pixels, cost.
Result<std::vector<Figure>> measureDepth(Bench& bench);

}  // namespace glibra::bench
