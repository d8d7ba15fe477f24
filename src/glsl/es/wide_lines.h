#pragma once
// Lines wider than the driver draws: the vertex stage makes quads of them, from the outputs that it has
// delivered for their ends before.

#include <vector>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// What the main function of the stage is called before widenLines() adds another one.
inline constexpr const char* kVertexMain = "glibra_vertexMain";

/// Adds a main function to the vertex stage of `stages`, which are GLSL ES: it calls kVertexMain, or makes
/// quads (WideLines). Returns nothing to capture if the program tells the strips that it emits, or if the
/// fragment stage reads structures, arrays whose size is not written as a number, or more than can be
/// captured; lines are then no wider than the driver draws them.
WideLines widenLines(std::vector<TranslatedStage>& stages, const ExpandedGeometry& expanded);

}  // namespace glibra::glsl
