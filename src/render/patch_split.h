#pragma once
// Patches drawn in several draws, on drivers that go wrong with a large one. Mesa's software drivers number
// the vertices that the patches of one draw become in 16 bits: beyond 65,536 of them triangles join the wrong
// ones. And they hand patches to the tessellator 1024 vertices at a time, of which each lot is counted from 0
// (both seen in 22.3.6).

#include <functional>

#include "glsl/types/translated_program.h"
#include "gpu/context.h"

namespace glibra::render {

/// Draws `indexCount` indices by calls of `drawPart`, with the program in use, which is made of `program`.
/// Between them it sets the uniforms that the translator adds to what reads the number of a patch or
/// primitive, so that each has its number within the whole.
void drawPatches(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program, int patchVertices,
                 int indexCount, const std::function<void(int first, int count)>& drawPart);

/// For who draws a part of the whole by a call of its own: its first patch is number `patch` of the whole.
void setFirstPatch(const glsl::TranslatedProgram& program, int patch);

}  // namespace glibra::render
