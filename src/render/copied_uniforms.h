#pragma once

#include "gpu/program.h"
#include "gpu/reflection.h"
#include "render/programs.h"

namespace glibra::render {

/// Gives every uniform, sampler and block of `program`, which is the one in use and has this interface, the
/// value that it has in the program that it was made from.
void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const gpu::ProgramInterface& reflected);

}  // namespace glibra::render
