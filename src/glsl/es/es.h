#pragma once
// A translated program once more, in GLSL ES 3.00: the language that browsers compile for WebGL 2. The core
// text is parsed again, so that what the rules added to it is adapted like what the user wrote.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "glsl/types/request.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

struct EsProgram {
    /// Their line maps lead to the lines of the user, as those of the core text do.
    std::vector<TranslatedStage> stages;
    std::vector<InitialValue> initialValues;
    ExpandedGeometry expanded{};
    std::map<std::string, std::string>
        userNames{};  ///< by the names in their place; those of the core text are not here
    WideLines wideLines{};
    std::vector<Place> loopSites{};  ///< the loops that are guarded (additions.h), of all stages
    /// What GLSL ES 3.00 lacks: web-E01 to web-E05, at the user's places. `stages` may then not compile.
    Diagnostics diagnostics;
};

/// `program` must have been translated without errors.
EsProgram toEs(const TranslatedProgram& program, const EsOptions& options = {});

}  // namespace glibra::glsl
