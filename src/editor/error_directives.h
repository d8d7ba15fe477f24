#pragma once
// The errors that every driver reports because the text of a shader asks for it.

#include <glibra/diagnostic.h>

#include "glsl/types/translated_program.h"

namespace glibra::editor {

/// The #error lines of all stages, and the #include lines that found no file, which become such lines: as
/// glsl-E01, with the texts and places that `glibra check` gives them. Empty if the program was not
/// translated.
Diagnostics errorDirectivesOf(const glsl::TranslatedProgram& program);

}  // namespace glibra::editor
