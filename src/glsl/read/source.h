#pragma once
// From the files of a stage to its tokens: versions and their tolerance (language, 7.2), #include, #line,
// #pragma once, #extension and the conditional branches (7.11), within the limits of section 11.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Reads the stage into `unit`: files, dialect, tokens, view, macros, extensions and the edits of its
/// directives.
void readSource(const StageSource& source, Unit& unit, Report& report);

/// `#line` so that the next line counts as `line` of file number `file` of the unit. `emittedVersion`: up to
/// 150 a driver counts one more.
std::string lineDirective(const Unit& unit, std::size_t file, long long line, int emittedVersion);

}  // namespace glibra::glsl
