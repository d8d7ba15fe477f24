#pragma once
// Makes text of unknown origin (messages, names, scenes) valid for JSON, XML and terminals.

#include <cstdint>
#include <string>
#include <string_view>

namespace glibra::suite {

/// One character of UTF-8.
struct Character {
    std::uint32_t code = 0;  ///< U+FFFD where the bytes are not UTF-8
    std::size_t bytes = 1;   ///< its length in the text
    bool valid = true;
};

/// Returns the first character of a text that is not empty, as RFC 3629 defines it: shortest form, no
/// surrogates, up to U+10FFFF. A byte that begins no such character is a character of its own, U+FFFD.
Character firstCharacter(std::string_view text);

/// True if all of it is UTF-8.
bool isUtf8(std::string_view text);

/// Appends the character, which must be valid.
void appendUtf8(std::string& text, std::uint32_t code);

/// For XML 1.0 and HTML, in element content and in attributes with double quotes. The characters & < > " '
/// are escaped. What XML cannot contain (most control characters, U+FFFE, U+FFFF, bytes that are not UTF-8)
/// becomes U+FFFD.
std::string escapeXml(std::string_view text);

/// For a terminal. Control characters, which could move the cursor or change its state, become U+FFFD. A line
/// end stays if `keepLines`; otherwise it becomes a blank.
std::string printableText(std::string_view text, bool keepLines = false);

}  // namespace glibra::suite
