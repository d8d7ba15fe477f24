#pragma once
// Soccer ball and teapot. Their resolution is the number of cells along an edge of their faces or patches.

#include <vector>

#include "bench/core/bench.h"
#include "bench/core/measurement.h"

namespace glibra::bench {

/// Distance and normals of the ball; outline and volume of both.
std::vector<Figure> cutShapeFigures(const Bench& bench);

}  // namespace glibra::bench
