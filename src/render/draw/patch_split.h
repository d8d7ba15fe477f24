#pragma once
// Splits a large draw of patches into several, for drivers that draw it wrongly. Mesa's software drivers
// (22.3.6) number the tessellated vertices of one draw in 16 bits, so that beyond 65,536 of them triangles
// use the wrong vertices. They also pass patches to the tessellator 1024 vertices at a time and restart
// gl_PrimitiveID at 0 each time.

#include <functional>

#include "glsl/types/translated_program.h"
#include "gpu/context/context.h"

namespace glibra::render {

/// Draws `indexCount` indices by calls of `drawPart`, with the program in use, which was built from
/// `program`. Between calls it sets the uniforms that the translator adds to stages that read gl_PrimitiveID,
/// so that each patch or primitive has its number within the whole draw.
void drawPatches(const gpu::Capabilities& driver, const glsl::TranslatedProgram& program, int patchVertices,
                 int indexCount, const std::function<void(int first, int count)>& drawPart);

/// For a caller that draws one part itself: sets the number that the part's first patch has within the whole
/// draw.
void setFirstPatch(const glsl::TranslatedProgram& program, int patch);

}  // namespace glibra::render
