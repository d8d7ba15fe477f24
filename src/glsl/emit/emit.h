#pragma once
// From a unit to the text for the driver, with the origin of every line.

#include "glsl/parse/unit.h"

namespace glibra::glsl {

/// Lines of the prologue and epilogue are numbered from here, so that no message of theirs looks like the
/// user's.
inline constexpr int kOwnLines = 100'000'000;

TranslatedStage emit(Unit& unit);

/// Only #version spelling and #include are handled (--no-shim).
TranslatedStage emitAsIs(Unit& unit);

}  // namespace glibra::glsl
