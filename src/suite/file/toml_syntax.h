#pragma once
// Explains why a text is not TOML.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::suite {

/// Returns the message of toml++ about that offset of the text, without its preamble, and what to write
/// instead if it is a common mistake.
std::string syntaxMessage(std::string_view said, std::string_view text, std::size_t offset);

/// Returns the offset of the first key with too many parts ("a.b.c"), or nothing. The parser makes a table of
/// each part and destroys them recursively, so a key of 100,000 parts would overflow the stack.
std::optional<std::size_t> endlessKey(std::string_view text);

}  // namespace glibra::suite
