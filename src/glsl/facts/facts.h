#pragma once
// What a translated program tells its users about its declarations.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Fills uniforms, textureBindings, vertexInputs and interfaceNames from the units.
void collectFacts(ProgramUnits& program);

}  // namespace glibra::glsl
