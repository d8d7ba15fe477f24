#pragma once

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Subject 7: objects far away and of all sizes, chained rotations, normals under uneven scales; in float and
/// double, on the CPU and in a shader, against 100 digits. Without a driver the shaders' curves are missing,
/// with gpu-E01 among the diagnostics.
Result<std::vector<Figure>> measureTransforms(Bench& bench);

// The figures one by one. They add what went wrong to `problems`.
Figure placementFigure(Bench& bench, bool byDistance, Diagnostics& problems);  ///< or by size
Figure chainFigure(Bench& bench, Diagnostics& problems);
Figure normalMatrixFigure(Bench& bench, Diagnostics& problems);

}  // namespace glibra::bench
