#pragma once
// The figures of measureTransforms. They add errors to `problems`.

#include <glibra/result.h>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Figure placementFigure(Bench& bench, bool byDistance, Diagnostics& problems);  ///< or by size
Figure chainFigure(Bench& bench, Diagnostics& problems);
Figure normalMatrixFigure(Bench& bench, Diagnostics& problems);

}  // namespace glibra::bench
