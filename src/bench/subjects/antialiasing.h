#pragma once
// Samples a pixel, and how they are weighted, against the picture that very many samples or an integral give.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// A figure a pattern: edges, a minified checkerboard, one in perspective, stripes.
Result<std::vector<Figure>> measureAntialiasing(Bench& bench);

}  // namespace glibra::bench
