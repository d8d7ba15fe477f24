#pragma once
// Subject 10: volume ray casting by steps against a fine integration.

#include <vector>

#include "bench/bench.h"
#include "bench/measurement.h"

namespace glibra::bench {

Result<std::vector<Figure>> measureVolume(Bench& bench);

}  // namespace glibra::bench
