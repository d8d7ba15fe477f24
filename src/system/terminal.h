#pragma once
// Standard input, output and error, and the terminals that they may be.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace glibra::system {

enum class Standard { input, output, error };

/// Opens the null device on those of the three that are closed, so that no file or pipe of the program is
/// taken for one of them. Reading and writing still fail, as on what is closed. Call it first in main.
/// Returns false if one stays closed.
bool openStandardFiles() noexcept;

bool isTerminal(Standard stream);
/// Columns of the terminal that errors go to; 80 if it is none.
std::size_t terminalColumns();
/// True if two of them lead to the same terminal or file.
bool isSameFile(Standard first, Standard second);

/// Reads what standard input has, at least one byte unless it ends. Returns 0 or an error number; `count` is
/// 0 at the end.
int readInput(std::span<char> bytes, std::size_t& count);
/// True if more input, or its end, is there or comes within the time; -1 waits for ever. Nothing:
/// interrupted.
std::optional<bool> isInputReady(int milliseconds);
/// Writes to standard output at once, without the buffer of stdout. Returns 0 or an error number.
int writeOutput(std::string_view text);

}  // namespace glibra::system
