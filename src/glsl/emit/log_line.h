#pragma once
// One line of a driver's log.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

struct LogLine {
    std::string source;  ///< the number or file name of the source
    int line = 0;
    int column = 0;  ///< 0: not given
    bool isWarning = false;
    bool collapsed = false;  ///< the column counts a run of blanks as one (Mesa's preprocessor)
    std::string text;
};

/// Understands `0:12(5): error: text` (Mesa), `0(12) : error C1008: text` (NVIDIA) and `ERROR: 0:12: text`
/// (AMD, Apple, Intel, glslang), each with a number or a file name as the source. `files` are the known
/// names, which may contain colons and blanks.
std::optional<LogLine> parseLogLine(std::string_view line, std::span<const std::string> files);

/// True for lines without information: "ERROR: 2 compilation errors.", "-----------".
bool isLogSummary(std::string_view line);

/// The stage that the lines after a heading like "Vertex info" are about; null for other lines.
const TranslatedStage* stageOfHeading(const TranslatedProgram& program, std::string_view line);

/// Removes "error: " or "warning: " from the front; true for a warning.
bool stripSeverity(std::string_view& text);

/// A place in the emitted source of a stage.
struct EmittedPlace {
    std::size_t line = 0;  ///< index into LineMap::lines
    int column = 0;        ///< from 1; 0: not known
};

/// The place that a message is about; nothing if no emitted line comes from that line of `file`.
std::optional<EmittedPlace> emittedPlace(const TranslatedStage& stage, const LogLine& line,
                                         const std::string& file);
/// The user's place of an emitted one.
struct UserPlace {
    LineOrigin line;
    int column = 1;                     ///< 1 if it is not known
    const MacroPlace* macro = nullptr;  ///< the word of a macro's text there; the place is that of the call
};
UserPlace userPlace(const TranslatedStage& stage, const EmittedPlace& place);

/// The line of that number, counted from 0, without its end; empty if there is none.
std::string_view lineOfText(std::string_view text, std::size_t number);

/// The first quoted word of a message: `foo', 'foo' or "foo"; empty if there is none.
std::string_view quotedWord(std::string_view text);

// ---- What a message is about
// What the message of a compile log is about, in the words of each compiler.

/// The name that a message says to be undeclared; empty if it says something else.
std::string_view undeclaredName(std::string_view message);

/// True for messages about types that do not fit.
bool isAboutTypes(std::string_view message);

/// True for messages that follow from an error before them on the same line.
bool isConsequence(std::string_view message);

/// True for a message that a token does not fit the grammar.
bool isSyntaxError(std::string_view message);

}  // namespace glibra::glsl
