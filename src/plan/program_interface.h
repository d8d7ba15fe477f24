#pragma once
// A linked program as the plan sees it: plain values, without GL.

#include "base/program_resources.h"
#include "glsl/types/translated_program.h"
#include "scene/index.h"

namespace glibra::plan {

using base::ActiveInput;
using base::ActiveUniform;
using base::BaseType;
using base::UniformBlock;
using base::ValueType;
using UniformIndex = scene::Index<ActiveUniform>;

/// What a program reads, with the translator's facts about its stages. The names of uniforms are the user's.
struct ProgramInterface : base::ActiveResources {
    glsl::TranslatedProgram facts;  ///< stages' sources may be empty; diagnostics of translating and linking
    bool usable = false;            ///< it linked; otherwise `facts.diagnostics` says why
    bool isBuiltin = false;         ///< glibra's own flat-colour program
};

}  // namespace glibra::plan
