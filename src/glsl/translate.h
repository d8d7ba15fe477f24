#pragma once
// Translates GLSL dialects (1.10 to 4.60, core, compatibility, EXT_geometry_shader4, GSTAP names) to one core
// version (language, 7). It needs no GL. The target is at least
// 4.10, and for compute stages 4.30.

#include "glsl/types/request.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Translates all stages of one program together. The user's mistakes are diagnostics, never exceptions.
TranslatedProgram translate(const ProgramRequest& request);

}  // namespace glibra::glsl
