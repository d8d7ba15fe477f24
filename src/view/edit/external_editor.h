#pragma once
// Opens a file in the user's own editor.

#include <glibra/diagnostic.h>

#include <sys/types.h>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace glibra::view {

// Starts programs: one that runs independently of this one, such as an editor, and this one again.

/// Starts the command in its own session, as a child of init. It outlives this program, gets no signals from
/// this program's terminal, and leaves no zombie process. The first word is searched in PATH. Returns the
/// reason if it cannot be started, such as "No such file or directory"; empty on success.
std::string startDetached(const std::vector<std::string>& command);

/// Starts this program again, as a child, with these words. Each pair of descriptors is one of this process
/// and the number that it has in the child; messages are discarded. Returns -1 if it cannot be started.
pid_t startAgain(std::vector<std::string> words, std::initializer_list<std::pair<int, int>> descriptors);

/// Starts $VISUAL or $EDITOR at that line without waiting for it, in a terminal if the editor needs one.
/// Returns a message for the status line: what was opened, or why it failed.
std::string openInEditor(const Place& place);

}  // namespace glibra::view
