#pragma once
// One line of a driver's log.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "glsl/translate.h"

namespace glibra::glsl {

struct LogLine {
    std::string source;  ///< number or file name of the source
    int line = 0;
    int column = 0;  ///< 0: not given
    bool isWarning = false;
    bool collapsed = false;  ///< the column counts runs of blanks as one (Mesa's preprocessor)
    std::string text;
};

/// Understands `0:12(5): error: text` (Mesa), `0(12) : error C1008: text` (NVIDIA), `ERROR: 0:12: text` (AMD,
/// Apple, Intel, glslang), each with a number or a file name as source. `files` are names that may have
/// colons in them.
std::optional<LogLine> parseLogLine(std::string_view line, std::span<const std::string> files);

/// Lines that only count or announce: "ERROR: 2 compilation errors.", "-----------".
bool isLogSummary(std::string_view line);

/// "Vertex info", "Fragment shader(s) failed to link, ...": the stage that the next lines are about, or null.
const TranslatedStage* stageOfHeading(const TranslatedProgram& program, std::string_view line);

/// Takes "error: " or "warning: " from the front; true for a warning.
bool stripSeverity(std::string_view& text);

/// The user's column for a message, 1 if it is not known.
int userColumn(const TranslatedStage& stage, const LogLine& line, const std::string& file);

}  // namespace glibra::glsl
