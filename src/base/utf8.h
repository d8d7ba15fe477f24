#pragma once
// Text of unknown origin (messages, names, scenes) as UTF-8, and in a form that a terminal shows and does not
// obey.

#include <cstdint>
#include <string>
#include <string_view>

namespace glibra::base {

/// Stands for what is not UTF-8: U+FFFD.
inline constexpr std::uint32_t kReplacement = 0xFFFD;

/// One character of UTF-8.
struct Character {
    std::uint32_t code = 0;  ///< kReplacement where the bytes are not UTF-8
    std::size_t bytes = 1;   ///< its length in the text
    bool valid = true;
};

/// Returns the first character of a text that is not empty, as RFC 3629 defines it: shortest form, no
/// surrogates, up to U+10FFFF. A byte that begins no such character is a character of its own, kReplacement.
Character firstCharacter(std::string_view text);

/// True if all of it is UTF-8.
bool isUtf8(std::string_view text);

/// The text with kReplacement for each byte that is no UTF-8.
std::string onlyUtf8(std::string_view text);

/// Appends the character, which must be valid.
void appendUtf8(std::string& text, std::uint32_t code);

/// The first character in quotes, and one that nobody sees by its number and name: "'\u00a0' (no-break
/// space)".
std::string visibleCharacter(std::string_view text);

/// Returns the text for a terminal or a line of a log. What could move the cursor, change the terminal's
/// state or reorder what is shown is written out: control characters and bytes that are not UTF-8 as \x1b, C1
/// controls, directional marks, invisible characters and line separators as \u202e or \U000e0001. A tab
/// becomes a blank. A line end stays if `keepLines`; otherwise it becomes a blank. The result is UTF-8, and
/// the same function leaves it as it is.
std::string printableText(std::string_view text, bool keepLines = false);

}  // namespace glibra::base
