#pragma once
// GLSL source text to tokens. Nothing is lost: the tokens' texts, blanks and comments included, make up the
// text again, except for the backslashes of joined lines, which become `splice` tokens.

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
    std::int32_t line = 1;    ///< from 1; after `source` as #line directives count it
    std::int32_t column = 1;  ///< bytes from 1
    std::uint16_t file = 0;   ///< index into the files of the stage
    TokenKind kind = TokenKind::other;
    bool active = true;             ///< false: in a branch of #if that is not compiled
    bool directive = false;         ///< stands on a preprocessor line
    bool droppedBackslash = false;  ///< a // comment that ended in a backslash
    bool synthetic = false;         ///< written by the translator
};

/// No index: tokens are counted in 32 bits, sources are limited to 4 MiB.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// True for what the grammar sees: not blanks, comments and line ends.
constexpr bool isSignificant(TokenKind kind) {
    return kind == TokenKind::word || kind == TokenKind::number || kind == TokenKind::punctuator ||
           kind == TokenKind::other;
}

/// The text with lines ended by LF alone, without a byte-order mark.
std::string normalizeLines(std::string_view text);

/// Tokens of `text`, whose lines end with LF. Words and numbers that a backslash joins over two lines are
/// stored in `storage`; the other tokens point into `text`.
std::vector<Token> lex(std::string_view text, std::deque<std::string>& storage);

}  // namespace glibra::glsl
