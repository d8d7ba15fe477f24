#pragma once
// Text of unknown origin (messages, names, scenes) made fit for JSON, XML and terminals.

#include <cstdint>
#include <string>
#include <string_view>

namespace glibra::suite {

/// One character of UTF-8.
struct Character {
    std::uint32_t code = 0;  ///< U+FFFD where the bytes are not UTF-8
    std::size_t bytes = 1;   ///< that it takes in the text
    bool valid = true;
};

/// The first character of a text that is not empty. Shortest form only, no surrogates, up to U+10FFFF
/// (RFC 3629); a byte that begins no such character stands alone.
Character firstCharacter(std::string_view text);

/// True if all of it is UTF-8.
bool isUtf8(std::string_view text);

/// Appends the character, which has to be valid.
void appendUtf8(std::string& text, std::uint32_t code);

/// For XML 1.0 and HTML, in element content and in attributes with double quotes: & < > " ' are escaped, and
/// what XML cannot hold at all (most control characters, U+FFFE, U+FFFF, bytes that are not UTF-8) is U+FFFD.
std::string escapeXml(std::string_view text);

/// For a terminal: control characters, which could move the cursor or change its state, are U+FFFD; a line
/// end stays if `keepLines`, else it is a blank.
std::string printableText(std::string_view text, bool keepLines = false);

}  // namespace glibra::suite
