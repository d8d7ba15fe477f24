#pragma once

#include <glibra/diagnostic.h>

#include <string>

namespace glibra::view {

/// Starts $VISUAL or $EDITOR at that line, in a terminal of its own where the editor needs one, and does not
/// wait. Returns what was done, or why it was not, for the status line.
std::string openInEditor(const Place& place);

}  // namespace glibra::view
