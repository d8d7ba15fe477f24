#pragma once
// Splits GLSL source text into tokens. The texts of all tokens, with blanks and comments, joined again give
// the source. The only exceptions are backslashes that join lines; they become `splice` tokens, after the
// token that they interrupt.

#include <cstdint>
#include <deque>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace glibra::glsl {

enum class TokenKind : std::uint8_t { word, number, punctuator, blank, splice, newline, comment, other };

/// Stands for "no token". Indices have 32 bits, because a source has at most 4 MiB.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Token {
    std::string_view text;
    std::int32_t line = 1;    ///< from 1; after readSource, as #line directives count it
    std::int32_t column = 1;  ///< in bytes, from 1
    /// Of a token from the text of a macro: the index into StageText::macroTexts. Its place is that of the
    /// call.
    std::uint32_t body = kNone;
    std::uint16_t file = 0;  ///< index into the files of the stage
    TokenKind kind = TokenKind::other;
    bool directive = false;         ///< it is on a preprocessor line
    bool expanded = false;          ///< it comes out of a macro call
    bool droppedBackslash = false;  ///< a // comment that ended in a backslash
    bool continuedComment = false;  ///< a // comment that a backslash continues in the next line
    bool synthetic = false;         ///< written by the translator
};

/// A token as the grammar sees it: a significant one of the text.
struct ViewToken {
    std::string_view text;
    std::uint32_t raw = 0;  ///< its index among the tokens
    TokenKind kind = TokenKind::word;
    bool isName = false;  ///< a keyword of the target that this source uses as a name (markNames)
};

/// True for tokens that the grammar sees; false for blanks, comments and line ends.
constexpr bool isSignificant(TokenKind kind) {
    return kind == TokenKind::word || kind == TokenKind::number || kind == TokenKind::punctuator ||
           kind == TokenKind::other;
}

constexpr bool opensBracket(std::string_view text) {
    return text == "(" || text == "[" || text == "{";
}
constexpr bool closesBracket(std::string_view text) {
    return text == ")" || text == "]" || text == "}";
}

/// For every bracket among the tokens the index of its partner; `none` for brackets without one and for all
/// other tokens. Kinds of brackets are not told apart.
template <class Tokens>
std::vector<std::uint32_t> matchBrackets(const Tokens& tokens, std::uint32_t none) {
    std::vector<std::uint32_t> matches(tokens.size(), none);
    std::vector<std::uint32_t> open;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (opensBracket(text)) {
            open.push_back(i);
        } else if (closesBracket(text) && !open.empty()) {
            matches[open.back()] = i;
            matches[i] = open.back();
            open.pop_back();
        }
    }
    return matches;
}

/// True if the two characters may belong to one token, so that text that ends in the first one and text that
/// begins with the second one need a blank between them.
constexpr bool growTogether(char left, char right) {
    if (base::isOfName(left)) return base::isOfName(right);
    if (left == '.') return right == '.' || (right >= '0' && right <= '9');
    if (right == '=') return std::string_view("+-*/%<>=!&|^").find(left) != std::string_view::npos;
    if (left == right) return std::string_view("+-<>&|^#/").find(left) != std::string_view::npos;
    return (left == '/' && right == '*') || (left == '*' && right == '/') || (left == '-' && right == '>');
}

/// The text with LF line ends and without a byte-order mark.
std::string normalizeLines(std::string_view text);

/// The tokens of `text`, whose lines end with LF. Tokens point into `text`, or into `storage` if backslashes
/// join lines. `joinsComments`: a backslash at the end of a // comment continues it in the next line, as from
/// GLSL 4.20 and GLSL ES 3.00 on; otherwise it is dropped.
std::vector<Token> lex(std::string_view text, std::deque<std::string>& storage, bool joinsComments = false);

}  // namespace glibra::glsl
