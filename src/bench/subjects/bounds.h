#pragma once
// --max-error on the scenes of the library that declare values with Bound.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// One figure per bound: error and time with the values that --max-error chooses, those of the scene, and the
/// finest ones.
Result<std::vector<Figure>> measureBounds(Bench& bench);

}  // namespace glibra::bench
