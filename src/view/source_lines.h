#pragma once
// The line of a file that a message is about.

#include <glibra/diagnostic.h>

#include <string>

namespace glibra::view {

/// The line as it stands in the file now, tabs as one blank each, without its end; empty if it is not there.
std::string sourceLine(const Place& place);
/// Blanks up to the column and a caret.
std::string caretLine(const std::string& line, int column);

}  // namespace glibra::view
