#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Objects far away and of all sizes, chained rotations, and normals under uneven scales; in float and
/// double, on the CPU and in a shader, against 100 digits. Without a driver, the curves of the shaders are
/// missing and gpu-E01 is among the diagnostics.
Result<std::vector<Figure>> measureTransforms(Bench& bench);

// The single figures. They add errors to `problems`.
Figure placementFigure(Bench& bench, bool byDistance, Diagnostics& problems);  ///< or by size
Figure chainFigure(Bench& bench, Diagnostics& problems);
Figure normalMatrixFigure(Bench& bench, Diagnostics& problems);

}  // namespace glibra::bench
