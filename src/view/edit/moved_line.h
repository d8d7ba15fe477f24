#pragma once
// Finds a line of a text again after an edit.

#include <string_view>

namespace glibra::view {

/// Where the line `line` (counted from 1) of the text `before` stands in the text `after`; 0 if it is gone.
/// Lines are known by their words; blanks at both ends do not count. A line that was edited is the one
/// between the same neighbours that begins with the same word, in order.
int movedLine(std::string_view before, std::string_view after, int line);

}  // namespace glibra::view
