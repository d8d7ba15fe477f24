#pragma once
// Shaders that stand under the word of another stage: the text of a geometry stage after Vertex.

#include <optional>
#include <string>

#include "glsl/emit/log_line.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

struct OtherStage {
    std::string text;  ///< of a message
    UserPlace place;   ///< of the word
};
/// For a stage that does not compile: its first word that only another stage can have, such as EmitVertex in
/// a vertex stage. Nothing if there is no such word.
std::optional<OtherStage> findOtherStage(const TranslatedStage& stage);

}  // namespace glibra::glsl
