#pragma once
// A translated program once more, in GLSL ES 3.00: the language that browsers compile for WebGL 2. The core
// text is parsed again, so that what the rules added to it is adapted like what the user wrote.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

struct EsProgram {
    /// Their line maps lead to the lines of the user, as those of the core text do.
    std::vector<TranslatedStage> stages;
    std::vector<InitialValue> initialValues;
    ExpandedGeometry expanded{};
    /// What GLSL ES 3.00 lacks: web-E01 to web-E05, at the user's places. `stages` may then not compile.
    Diagnostics diagnostics;
};

/// `program` must have been translated without errors. `hasBorders`: textures that it reads may have a
/// border, which whoever draws says by the uniforms of borders.h. `patchVertices`: of the patches that it
/// draws.
EsProgram toEs(const TranslatedProgram& program, bool hasBorders = false, int patchVertices = 3);

}  // namespace glibra::glsl
