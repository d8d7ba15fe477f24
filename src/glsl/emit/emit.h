#pragma once
// Turns a unit into the text for the driver, with the origin of every line.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Lines of the prologue and the epilogue are numbered from here, so that messages about them are not taken
/// for messages about the user's lines.
inline constexpr int kOwnLines = 100'000'000;

TranslatedStage emit(Unit& unit);

/// The text of a stage that is not translated (--no-shim): only #version and #include lines change.
TranslatedStage emitAsIs(Unit& unit);

}  // namespace glibra::glsl
