#pragma once
// The figures of measureCurves.

#include <glibra/result.h>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

Figure parameterFigure(Bench& bench, Diagnostics& problems);
Figure chordFigure(const Bench& bench, bool isStep);  ///< of a steep step or of a Bézier curve
Figure streamlineFigure(const Bench& bench);

}  // namespace glibra::bench
