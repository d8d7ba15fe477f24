#pragma once
// What a program that was made from another one takes over from it.

#include <vector>

#include "gpu/program.h"
#include "render/programs.h"

namespace glibra::render {

/// Where its vertex inputs are: a program with the same can be drawn with the same vertex arrays.
std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of);

/// Gives every uniform, sampler and block of `program`, which is the one in use and has this interface, the
/// value that it has in the program that it was made from.
void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const base::ActiveResources& reflected);

}  // namespace glibra::render
