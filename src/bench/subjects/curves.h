#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// A curve parameter accumulated or computed; chords of curves at fixed steps and by flatness; streamlines
/// with fixed and adaptive steps. Without a driver, the curve of the shader is missing and gpu-E01 is among
/// the diagnostics.
Result<std::vector<Figure>> measureCurves(Bench& bench);

// The single figures.
Figure parameterFigure(Bench& bench, Diagnostics& problems);
Figure chordFigure(const Bench& bench, bool isStep);  ///< of a steep step or of a Bézier curve
Figure streamlineFigure(const Bench& bench);

}  // namespace glibra::bench
