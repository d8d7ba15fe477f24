#pragma once
// Private to this room: the functions that execute statements.

#include <span>

#include "scene/run/state.h"

namespace glibra::scene {

/// The actions of all commands by CommandId. The element of a command without an action has no handler.
std::span<const CommandAction> allActions();

}  // namespace glibra::scene
