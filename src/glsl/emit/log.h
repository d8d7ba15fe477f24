#pragma once
// The driver's compile and link logs in the user's terms (language, 7.12): the user's files, lines and names.

#include <glibra/diagnostic.h>

#include <string_view>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The driver's compile log as diagnostics at the user's files and lines. Errors have the id glsl-E01; the
/// driver's warnings become warnings without an id. Understands the formats of Mesa, NVIDIA, AMD/ATI, Apple
/// and glslang.
Diagnostics explainCompileLog(const TranslatedProgram& program, const TranslatedStage& stage,
                              std::string_view log);

/// The driver's link log, as glsl-E02 at the place of the program. It names files and lines where the log
/// names a variable that the sources declare.
Diagnostics explainLinkLog(const TranslatedProgram& program, std::string_view log, const Place& programPlace);

}  // namespace glibra::glsl
