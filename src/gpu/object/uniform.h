#pragma once
// Sets and reads uniforms of any GLSL type as doubles.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/program_resources.h"
#include "gpu/object/program.h"

namespace glibra::gpu {

/// Sets the elements of a uniform of the default block from firstElement on; the program need not be in use.
/// `values` are ordered by component, then column, then element; an incomplete last element and elements
/// beyond the array are ignored. Float types are rounded to nearest once; integers are truncated and limited
/// to the type's range, and NaN becomes 0; bool is value != 0. Samplers and images take the unit. Returns how
/// many elements were set.
int setUniform(const Program& program, const base::ActiveUniform& uniform, std::span<const double> values,
               int firstElement = 0);

/// The same for a member of a uniform block: writes into the memory of that block (UniformBlock::bytes
/// bytes). Components that would lie outside `block` are ignored.
int writeBlockMember(std::span<std::byte> block, const base::ActiveUniform& uniform,
                     std::span<const double> values, int firstElement = 0);

/// The current value of one element of a uniform of the default block.
std::vector<double> getUniform(const Program& program, const base::ActiveUniform& uniform, int element = 0);

// Queries a linked program for what it reads. Without GL 4.3 neither storage blocks nor
// fragment outputs are listed.

/// Sets `name` and `emittedName` of a uniform to the same text; a caller that knows the user's names replaces
/// `name`.
base::ActiveResources reflect(const Program& program);

/// The location of a colour output of the fragment stage, by its name in the compiled source; -1 if it is not
/// active.
int outputLocation(const Program& program, const std::string& name);

}  // namespace glibra::gpu
