#pragma once
// Splits GLSL source text into tokens. The texts of all tokens, with blanks and comments, joined again give
// the source. The only exceptions are backslashes that join lines; they become `splice` tokens.

#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::glsl {

enum class TokenKind : std::uint8_t { word, number, punctuator, blank, splice, newline, comment, other };

struct Token {
    std::string_view text;
    std::int32_t line = 1;    ///< from 1; after readSource, as #line directives count it
    std::int32_t column = 1;  ///< in bytes, from 1
    std::uint16_t file = 0;   ///< index into the files of the stage
    TokenKind kind = TokenKind::other;
    bool active = true;             ///< false: in a branch of #if that is not compiled
    bool directive = false;         ///< it is on a preprocessor line
    bool droppedBackslash = false;  ///< a // comment that ended in a backslash
    bool synthetic = false;         ///< written by the translator
};

/// Stands for "no token". Indices have 32 bits, because a source has at most 4 MiB.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// True for tokens that the grammar sees; false for blanks, comments and line ends.
constexpr bool isSignificant(TokenKind kind) {
    return kind == TokenKind::word || kind == TokenKind::number || kind == TokenKind::punctuator ||
           kind == TokenKind::other;
}

/// True for letters, digits and '_'.
constexpr bool isWordPart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The text with LF line ends and without a byte-order mark.
std::string normalizeLines(std::string_view text);

/// The tokens of `text`, whose lines end with LF. Tokens point into `text`, except for words and numbers that
/// a backslash joins over two lines: they point into `storage`.
std::vector<Token> lex(std::string_view text, std::deque<std::string>& storage);

}  // namespace glibra::glsl
