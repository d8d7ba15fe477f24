#pragma once
// Short ways to translate a few lines of GLSL and to examine the result.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/translate.h"

namespace glibra::glsl::test {

using Stages = std::vector<std::pair<Stage, std::string>>;

/// A program from (stage, text) pairs; the files are named a.vert, a.tesc, a.tese, a.geom, a.frag, a.comp.
ProgramRequest program(Stages stages);
TranslatedProgram translateStages(Stages stages);

/// A program of one stage. `#version 330` is added unless the text has a #version line.
ProgramRequest single(Stage stage, std::string text);
TranslatedProgram translateSingle(Stage stage, std::string text);

/// The emitted source of a stage; empty if there is none.
std::string sourceOf(const TranslatedProgram& translated, Stage stage);
/// The emitted text of a stage after the prologue.
std::string userPart(const TranslatedProgram& translated, Stage stage);
/// That of a program of one fragment stage.
std::string userFragment(const std::string& text);

/// True if the tokens of `wanted` are in `text` one after the other. Blanks, line ends and comments do not
/// matter.
bool hasTokens(std::string_view text, std::string_view wanted);

/// The ids of all messages in order, separated by blanks.
std::string ids(const Diagnostics& diagnostics);
/// The text of the first message with that id; empty if there is none.
std::string textOf(const Diagnostics& diagnostics, std::string_view id);
Place placeOf(const Diagnostics& diagnostics, std::string_view id);
bool has(const Diagnostics& diagnostics, std::string_view id);

/// The messages of glslangValidator about the stages, linked together; empty if it accepts them.
std::string glslangErrors(const TranslatedProgram& translated);

/// What glslangValidator prints when it compiles and links the stages with these options. `folder` is where
/// it found them.
std::string glslangOutput(const TranslatedProgram& translated, const std::string& options,
                          std::string* folder = nullptr);

inline const std::string kPlainVertex = "#version 330\nvoid main() { gl_Position = vec4(0.); }\n";
inline const std::string kPlainFragment =
    "#version 330\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n";

}  // namespace glibra::glsl::test
