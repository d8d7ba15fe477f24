#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Subject 9: a curve's parameter summed up or computed; chords of curves at fixed steps and by flatness;
/// streamlines by fixed and adaptive steps. Without a driver the shader's curve is missing, with gpu-E01
/// among the diagnostics.
Result<std::vector<Figure>> measureCurves(Bench& bench);

// The figures one by one.
Figure parameterFigure(Bench& bench, Diagnostics& problems);
Figure chordFigure(const Bench& bench, bool isStep);  ///< of a steep step, or of a Bézier curve
Figure streamlineFigure(const Bench& bench);

}  // namespace glibra::bench
