#pragma once
// A stage whose main is called from another main, for programs that observe what a scene's stage does.

#include <string>
#include <string_view>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// GLSL around the main of a stage.
struct MainWrapper {
    std::string_view declarations;  ///< at file scope, after the stage's own text
    std::string_view before;        ///< statements of the new main before it calls the stage's own
    std::string_view after;         ///< statements after that call
};

/// The source of the stage with its main renamed to glibra_sceneMain and a new main that calls it.
std::string wrappedMain(const TranslatedStage& stage, const MainWrapper& wrapper);

/// The stage's #version line with its line end, "#version 410 core\n" if it has none.
std::string versionLine(const TranslatedStage& stage);

}  // namespace glibra::glsl
