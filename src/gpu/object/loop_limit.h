#pragma once

#include "gpu/context/context.h"

namespace glibra::gpu {

/// The number of loop rounds, over all loops of a shader, after which the driver ends them without an error
/// (llvmpipe: 65,535); 0 if a million rounds pass. The function draws one pixel, which takes some
/// milliseconds, and leaves another target, program and vertex array bound.
int measureLoopLimit(const Context& context);

}  // namespace glibra::gpu
