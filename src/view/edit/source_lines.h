#pragma once
// The source line of a message.

#include <glibra/diagnostic.h>

#include <string>
#include <string_view>

namespace glibra::view {

/// The line as it is in the file now, without its end, with each tab as one blank. Empty if the file has no
/// such line.
std::string sourceLine(const Place& place);

/// The part of a line that fits into the available width, with a caret line below it.
struct Excerpt {
    std::string text;
    std::string caret;  ///< blanks up to the column and '^'
};

/// The line, with a caret under the byte at `column` (counted from 1; a column past the end puts the caret
/// after the line). If the line is longer than `most` UTF-8 characters (at least 12), only the part around
/// the column is shown, with "..." in place of the rest.
Excerpt excerpt(std::string_view line, int column, int most);

}  // namespace glibra::view
