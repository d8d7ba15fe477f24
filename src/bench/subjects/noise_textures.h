#pragma once
// Noise textures: size and texel format against the function that they hold.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: interpolated on the CPU; octave by octave; drawn by filters of the driver and of the shader and
/// by the function itself; across the border of the period.
Result<std::vector<Figure>> measureNoise(Bench& bench);

}  // namespace glibra::bench
