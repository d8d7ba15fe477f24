#pragma once
// Values of uniforms from doubles, whatever their GLSL type.

#include <glad/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "gpu/program.h"
#include "gpu/reflection.h"

namespace glibra::gpu {

/// Sets elements firstElement.. of a uniform of the default block; the program need not be in use. `values`:
/// component by component, column by column, element by element; an incomplete last element is left out,
/// elements beyond the array too. float types are rounded to nearest once; integers are cut towards zero and
/// limited to the type's range; bool is value != 0; NaN becomes 0 for integers. Samplers and images take the
/// unit. Returns how many elements were set.
int setUniform(const Program& program, const ActiveUniform& uniform, std::span<const double> values,
               int firstElement = 0);

/// The same for a member of a uniform block, into the memory of that block (UniformBlock::bytes of it). What
/// would lie outside `block` is left out.
int writeBlockMember(std::span<std::byte> block, const ActiveUniform& uniform, std::span<const double> values,
                     int firstElement = 0);

/// The value of a uniform of the default block as it is now, element 0 or the one asked for.
std::vector<double> getUniform(const Program& program, const ActiveUniform& uniform, int element = 0);

/// Chooses functions of subroutine uniforms for the program in use: one function index for each location of
/// that stage, as `choices` says (location, function index), others keep their first function. GL forgets
/// them at every glUseProgram.
void useSubroutines(const ProgramInterface& interface, GLenum stage,
                    std::span<const std::pair<int, GLuint>> choices = {});

}  // namespace glibra::gpu
