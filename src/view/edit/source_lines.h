#pragma once
// The line of a file that a message is about.

#include <glibra/diagnostic.h>

#include <string>
#include <string_view>

namespace glibra::view {

/// The line as it stands in the file now, tabs as one blank each, without its end; empty if it is not there.
std::string sourceLine(const Place& place);

/// What is shown of a line where it has not enough room.
struct Excerpt {
    std::string text;
    std::string caret;  ///< blanks up to the column and '^'
};

/// The line with a caret under the byte of that column (from 1; beyond the end: behind it). Of a line longer
/// than `most` characters (at least 12) only the part around the column, with "..." for what is left out.
/// Characters are those of UTF-8.
Excerpt excerpt(std::string_view line, int column, int most);

}  // namespace glibra::view
