#pragma once
// Turns a unit into the text for the driver, with the origin of every line.

#include "glsl/parse/unit.h"

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

}  // namespace glibra::glsl
