#pragma once
// Private to this room: runs statements, and finds the files that they name.

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "scene/run/state.h"

namespace glibra::scene {

/// The action of a command among those of all; null if it has none.
const CommandAction* actionOf(std::span<const CommandAction> actions, CommandId command);

/// Runs one statement. A command that opens a block runs the block.
void execute(Interpreter&, const Command& command);

/// Runs the statements [first, last) of the current script. Each block runs its own statements.
void run(Interpreter&, std::size_t first, std::size_t last);
/// Makes the names known that the statements of the current script declare, before they run.
void expectNames(Interpreter&);
/// Runs the statements between two commands of the current script. Reports glib-W31.
void runBody(Interpreter&, std::size_t first, std::size_t last);
/// The index of a command of the current script.
std::size_t indexOf(const Interpreter&, const Command&);
/// The number of the file that the current statement stands in: 0 for the scene's own, then the included ones
/// in the order in which they were read first.
int fileNumber(const Interpreter&);

/// Sets the names of time that a frame has: time, dt, frame and tick.
void setTime(Interpreter&);

/// Returns the index of the file that a statement names. The file is looked up the first time.
FileIndex fileOf(Interpreter&, const std::string& name, const Place& place);
/// The file of that key; `make` is called once for all frames of the script.
FileIndex fileNamed(Interpreter&, const std::string& key, const std::function<FileReference()>& make);

/// Returns the statement as it appears in messages: "Sphere 1 60 60".
std::string textOf(const Command& command);

}  // namespace glibra::scene
