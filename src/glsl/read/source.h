#pragma once
// From the files of a stage to its tokens: versions and their tolerance (language, 7.2), #include, #line,
// #pragma once, #extension and conditional branches (language, 7.11), within the limits of language, 11.

#include <string>

#include "glsl/read/report.h"
#include "glsl/read/stage_text.h"
#include "glsl/types/request.h"

namespace glibra::glsl {

/// How the message on an #include whose file is not found begins; its name and a ' follow.
inline constexpr const char* kMissingInclude = "cannot find the included file '";

/// Reports file-E08 for a file that is no text: a picture, or UTF-16. False if it is one.
bool isSourceText(const std::string& path, const std::string& text, Report& report);

/// Reads a stage whose `request` is set: files, dialect, tokens, view, macros, extensions, and the edits of
/// its directives.
void readSource(const StageSource& source, StageText& stage, Report& report);

/// A #line directive after which the next line counts as `line` of the stage's file number `file`. Drivers
/// for an `emittedVersion` up to 150 count one more, which this allows for.
std::string lineDirective(const StageText& stage, std::size_t file, long long line, int emittedVersion);

}  // namespace glibra::glsl
