#pragma once
// Private to this room: how many statements, rounds and elements a frame may have.

#include <cstddef>

#include "scene/run/state.h"

namespace glibra::scene {

/// Statements that one frame may execute; those of repetitions and groups count each time.
inline constexpr std::size_t kMostStatements = 1'000'000;

/// Counts a statement that is about to run. False, with glib-E15, if there are too many.
bool countStatement(Interpreter&, const Command& command);
/// The same for a round of Repeat, whether or not it has statements.
bool countRound(Interpreter&, const Command& command);
/// The same for elements that an expression of `i` gives a list or array.
bool countElements(Interpreter&, const Value& owner, double count);

}  // namespace glibra::scene
