#pragma once
// The driver's compile and link logs in the user's terms (language, 7.12): the user's files, lines and names.

#include <glibra/diagnostic.h>

#include <string_view>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The errors of a driver's compile log, as glsl-E01 at the user's files and lines. Warnings are left out: a
/// driver gives none for a shader that its cache has, so they would come and go; facts/ has checks that do
/// not. Understands the formats of Mesa, NVIDIA, AMD/ATI, Apple and glslang.
Diagnostics explainCompileLog(const TranslatedProgram& program, const TranslatedStage& stage,
                              std::string_view log);

/// The driver's link log, as glsl-E02 at the place of the program. It names files and lines where the log
/// names a variable that the sources declare.
Diagnostics explainLinkLog(const TranslatedProgram& program, std::string_view log, const Place& programPlace);

}  // namespace glibra::glsl
