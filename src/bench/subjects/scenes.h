#pragma once
// The scenes that ship with glibra: their time and their error.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureScenes(Bench& bench);

}  // namespace glibra::bench
