#pragma once
// Opens a file in the user's own editor.

#include <glibra/diagnostic.h>

#include <string>

namespace glibra::view {

/// Starts $VISUAL or $EDITOR, or else the editor that the system has, at that line without waiting for it, in
/// a terminal if the editor needs one. Returns a message for the status line: what was opened, or why it
/// failed.
std::string openInEditor(const Place& place);

}  // namespace glibra::view
