#pragma once
// Patches drawn in several draws, on drivers that lose some of a large one.

#include <glad/gl.h>

#include "glsl/translate.h"
#include "gpu/context.h"

namespace glibra::render {

/// Patches that one draw may have; 1 or more. Mesa's software drivers number the vertices that the patches of
/// one draw become in 16 bits (seen in 22.3.6): beyond 65,536 of them triangles join the wrong ones.
int patchesAtOnce(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program);

/// The place of the uniform of the program in use that the translator adds to what reads gl_PrimitiveID: the
/// number of patches in the draws before this one. -1: there is none.
GLint firstPatchLocation(const glsl::TranslatedProgram& program);

}  // namespace glibra::render
