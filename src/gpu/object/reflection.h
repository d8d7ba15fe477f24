#pragma once
// Queries a linked program for what it reads. Without GL 4.3 neither storage blocks nor
// fragment outputs are listed.

#include <string>

#include "base/program_resources.h"
#include "gpu/object/program.h"

namespace glibra::gpu {

/// Sets `name` and `emittedName` of a uniform to the same text; a caller that knows the user's names replaces
/// `name`.
base::ActiveResources reflect(const Program& program);

/// The location of a colour output of the fragment stage, by its name in the compiled source; -1 if it is not
/// active.
int outputLocation(const Program& program, const std::string& name);

}  // namespace glibra::gpu
