#pragma once
// The functions of GLSL on this driver against long double.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureBuiltins(Bench& bench);

}  // namespace glibra::bench
