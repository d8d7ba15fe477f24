#pragma once

#include "gpu/context.h"

namespace glibra::gpu {

/// Rounds after which the driver ends the loops of a shader, all together, without a word; 0 if it lets a
/// million pass. Found by drawing a pixel, which takes some milliseconds; leaves another target, program and
/// vertex array bound. llvmpipe: 65,535.
int measureLoopLimit(const Context& context);

}  // namespace glibra::gpu
