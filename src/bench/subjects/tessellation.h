#pragma once
// Tessellation shaders: levels and spacings against analytic surfaces, and cracks between patches.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: largest and mean distance of a Bezier patch, an octant of a sphere and a PN triangle; cracks
/// along the shared edges of the teapot; gaps between neighbours of different levels.
Result<std::vector<Figure>> measureTessellation(Bench& bench);

/// The figures of measureTessellation that concern edges.
Result<std::vector<Figure>> measureCracks(const Bench& bench, const gpu::Capabilities& capabilities);

}  // namespace glibra::bench
