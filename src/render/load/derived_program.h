#pragma once
// What a program takes over from the program that it was made from.

#include <vector>

#include "gpu/object/program.h"
#include "render/load/programs.h"

namespace glibra::render {

/// The locations of its vertex inputs. A program with equal locations can be drawn with the same vertex
/// arrays.
std::vector<gpu::NamedLocation> inputLocations(const BuiltProgram& of);

/// Gives every uniform, sampler and block of `program` its value in `from`. `program` must be in use, and
/// `reflected` is its interface.
void copyUniforms(const BuiltProgram& from, const gpu::Program& program,
                  const base::ActiveResources& reflected);

}  // namespace glibra::render
