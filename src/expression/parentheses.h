#pragma once
// Which parentheses of a line hold an expression (language, 1.8).

#include <cstddef>
#include <string_view>

namespace glibra::expression {

/// The offset of the ')' that belongs to the '(' at `open`, before any comment; npos if there is none. `text`
/// may have several lines if the statement does; comments end with their line.
std::size_t partnerOf(std::string_view text, std::size_t open);

}  // namespace glibra::expression
