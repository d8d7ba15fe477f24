#pragma once
// Which parentheses of a line hold an expression (language, 1.8).

#include <cstddef>
#include <string_view>

namespace glibra::expression {

/// The offset of the ')' that belongs to the '(' at `open`, before any comment; npos if there is none. `text`
/// may have several lines if the statement does; comments end with their line.
std::size_t partnerOf(std::string_view text, std::size_t open);

/// In a classic statement, tells an expression from a bracket that stands for `[ ... ]` (language, 1.6).
/// `line` is one line of a scene, and line[open] is a '('. True if its partner stands on the line before any
/// comment, and between them a word begins with a letter or _ (except `true` and `false`), or one of + - * /
/// % = ! & | stands other than as the sign of a number or in its exponent.
bool beginsExpression(std::string_view line, std::size_t open);

}  // namespace glibra::expression
