#pragma once
// A program that runs on its own: an editor, a viewer.

#include <string>
#include <vector>

namespace glibra::view {

/// Starts it in a session of its own, as nobody's child: it outlives this program, signals of its terminal do
/// not reach it, and nothing is left of it when it ends. The first word is looked for in PATH. Returns why it
/// could not be started, as "No such file or directory"; empty if it runs.
std::string startDetached(const std::vector<std::string>& command);

}  // namespace glibra::view
