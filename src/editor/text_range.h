#pragma once
// Places in a text, and the word or line at one.

#include <cstddef>
#include <optional>
#include <string_view>

namespace glibra::editor {

/// Byte offsets in a text.
struct TextRange {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const TextRange&, const TextRange&) = default;
};

/// The word that touches the byte; empty if there is none.
TextRange wordAt(std::string_view text, std::size_t byte);
/// The same, or else the last name before the byte in its line; empty if there is none. Numbers are no names.
TextRange nameNear(std::string_view text, std::size_t byte);
/// The first place from `begin` and before `end` where the word stands as a whole.
std::optional<TextRange> findWord(std::string_view text, std::string_view word, std::size_t begin,
                                  std::size_t end);
/// The part of that word before the byte.
TextRange wordBefore(std::string_view text, std::size_t byte);

/// The part of the line before the byte.
std::string_view lineBefore(std::string_view text, std::size_t byte);
/// The part of a scene's statement before the byte. It begins lines earlier if they end with '\'.
std::string_view statementBefore(std::string_view text, std::size_t byte);

}  // namespace glibra::editor
