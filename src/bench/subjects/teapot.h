#pragma once
// The part of the primitives that is no solid of closed form.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

inline constexpr double kTeapotTriangles = 16256;

/// Position (in units of half the body's width) and normal of grids on the teapot's patches, by cells a
/// side, against the patches in double; the last curve of each is the teapot that scenes draw.
std::vector<Figure> teapotFigures(const Bench& bench);

}  // namespace glibra::bench
