#pragma once
// Splits the text of an expression into tokens.

#include <cstddef>
#include <string_view>

#include "expression/problem.h"

namespace glibra::expression {

enum class TokenKind { end, number, name, sign, wrong };

struct Token {
    TokenKind kind = TokenKind::end;
    std::string_view text;
    Range range;
    double number = 0;
    const char* why = nullptr;  ///< of what is wrong

    [[nodiscard]] bool is(std::string_view sign) const { return kind == TokenKind::sign && text == sign; }
};

/// Blanks, ends of lines, backslashes before them, and comments separate tokens.
class Lexer {
  public:
    explicit Lexer(std::string_view text) : text_(text) {}
    Token next();

  private:
    void skipBlanks();
    Token number();
    Token token(TokenKind kind, std::size_t length) const;
    [[nodiscard]] Token wrong(std::size_t length, const char* why) const;

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace glibra::expression
