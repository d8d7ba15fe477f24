#pragma once
// Volume ray casting in steps against a fine integration.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureVolume(Bench& bench);

}  // namespace glibra::bench
