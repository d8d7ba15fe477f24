#pragma once
// Turns a unit into the text for the driver, with the origin of every line.

#include <glibra/diagnostic.h>

#include <string>
#include <string_view>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// Lines of the prologue and the epilogue are numbered from here, so that messages about them are not taken
/// for messages about the user's lines.
inline constexpr int kOwnLines = 100'000'000;
/// Mesa leaves the number of the source out of its messages about GLSL ES. There the line numbers tell it:
/// source n has those from n times this on.
inline constexpr int kLinesOfSource = 1'000'000;

TranslatedStage emit(Unit& unit);

/// The text of a stage that is not translated (--no-shim): only #version and #include lines change.
TranslatedStage emitAsIs(Unit& unit);

// ---- Emitted texts

/// A line of a translated source.
struct EmittedLine {
    int number = 0;  ///< in TranslatedStage::source, from 1
    std::string text;
};

/// The lines that the translation of a stage made of the user's line at `place`, in order, without blank
/// lines and #line directives.
std::vector<EmittedLine> emittedLines(const TranslatedStage& stage, const Place& place);

inline bool isLineNumber(std::string_view line) {
    return line.starts_with("#line ");
}

/// Without the characters that end them.
std::vector<std::string_view> textLines(std::string_view text);

/// "#line 2000012 2" for "#line 12 1", if there is one source `before` those of the text (kLinesOfSource).
/// Numbers may stand in quotes, and may have got their source already. Directives without a source stay as
/// they are.
std::string withSource(std::string_view directive, int before);

// ---- A stage whose main is called from another main, for programs that observe what a scene's stage does

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
