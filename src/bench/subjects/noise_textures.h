#pragma once
// Noise textures: error against size and texel format.

#include <glibra/result.h>

#include <vector>

#include "bench/core/bench.h"

namespace glibra::bench {

/// Figures: interpolated on the CPU; octave by octave; drawn with the filters of the driver and of the shader
/// and with the function itself; across the border of the period.
Result<std::vector<Figure>> measureNoise(Bench& bench);

}  // namespace glibra::bench
