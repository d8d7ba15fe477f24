#pragma once
// Samples per pixel and their weights, against the picture from very many samples or from an integral.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// One figure per pattern: edges, a minified checkerboard, one in perspective, stripes.
Result<std::vector<Figure>> measureAntialiasing(Bench& bench);

}  // namespace glibra::bench
