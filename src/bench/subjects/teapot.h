#pragma once
// The primitives that have no closed form.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

inline constexpr double kTeapotTriangles = 16256;

/// Position (in units of half the width of the body) and normal of grids on the patches of the teapot, by
/// cells per side, against the patches in double. The last curve of each figure is the teapot in scenes.
std::vector<Figure> teapotFigures(const Bench& bench);

}  // namespace glibra::bench
