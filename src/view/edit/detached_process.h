#pragma once
// Starts a program that runs independently of this one, such as an editor.

#include <string>
#include <vector>

namespace glibra::view {

/// Starts the command in its own session, as a child of init. It outlives this program, gets no signals from
/// this program's terminal, and leaves no zombie process. The first word is searched in PATH. Returns the
/// reason if it cannot be started, such as "No such file or directory"; empty on success.
std::string startDetached(const std::vector<std::string>& command);

}  // namespace glibra::view
