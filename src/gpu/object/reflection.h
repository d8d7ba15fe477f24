#pragma once
// Queries a linked program for what it reads. Without GL 4.3 it has no storage blocks.

#include "base/program_resources.h"
#include "gpu/object/program.h"

namespace glibra::gpu {

/// Sets `name` and `emittedName` of a uniform to the same text; a caller that knows the user's names replaces
/// `name`.
base::ActiveResources reflect(const Program& program);

}  // namespace glibra::gpu
