#pragma once
// Subject 15: the scenes that ship with glibra, their time and their error.

#include <vector>

#include "bench/bench.h"
#include "bench/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureScenes(Bench& bench);

}  // namespace glibra::bench
