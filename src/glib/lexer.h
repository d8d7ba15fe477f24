#pragma once
// Splits a text into lines and tokens (language, 1.1, 1.2, 1.4). Tokens point into the text, which must
// outlive them.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "glib/message_log.h"
#include "glib/parentheses.h"
#include "glib/script.h"

namespace glibra::glib {

enum class TokenKind {
    word,
    quoted,      ///< a word in quotes: never a command, a number or `true`
    number,      ///< begins with a number; more text may follow it
    open,        ///< one of < [ { (
    close,       ///< one of > ] } )
    expression,  ///< ( ... ); the text is without the outer parentheses
};

struct Token {
    TokenKind kind = TokenKind::word;
    std::string_view text;  ///< without quotes, commas at the end and the continuation backslash
    std::size_t begin = 0;  ///< byte offsets in the file; quotes are included
    std::size_t end = 0;
    Position position;

    [[nodiscard]] bool isWord() const { return kind == TokenKind::word || kind == TokenKind::quoted; }
    /// True for a number, an expression, and the beginning of a bracket group.
    [[nodiscard]] bool beginsValue() const {
        return kind == TokenKind::number || kind == TokenKind::open || kind == TokenKind::expression;
    }
    /// The value of the unquoted words `true` and `false`, in any case; nothing for other tokens.
    [[nodiscard]] std::optional<bool> truth() const;
};

/// The bytes of one line, without its end; `begin` and `end` count from the file's first byte.
struct LineRange {
    int number = 1;
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// One line that has been read.
struct Line {
    LineRange range;
    std::vector<Token> tokens;
    bool continues = false;  ///< ends with a backslash, at `backslash`
    Position backslash;
    bool isComment = false;    ///< the line has a comment
    bool faulty = false;       ///< an error was reported; the statement must not be run
    bool tooLong = false;      ///< refused (glib-E15); the line has no tokens
    bool isMessage = false;    ///< a MessageBox: there is one token, and the rest of the line is `message`
    std::string_view message;  ///< without blanks at either end
    std::size_t messageEnd = 0;
};

/// Splits a text at LF, CR LF and lone CR. Skips a byte-order mark.
class LineSplitter {
  public:
    explicit LineSplitter(std::string_view text);
    std::optional<LineRange> next();

  private:
    std::string_view text_;
    std::size_t at_ = 0;
    int number_ = 0;
};

/// A number token: its value, and its text without the part that was ignored.
struct ReadNumber {
    double value = 0;
    std::string_view text;
};

/// Reads any token as a number. Reports glib-W04, W05, E31; `hint` follows glib-W05 about a name.
ReadNumber readNumber(const Token& token, MessageLog& log, std::string_view hint = {});

/// How a line that begins with MessageBox is read.
enum class MessageLines { rawText, tokens };

/// Reads one line, or several that goesOnInParentheses() joins. `parentheses` says which of them are
/// expressions. Reports glib-E02, E03, E15 (length), W01, W02, W03, W35.
Line readLine(std::string_view text, const LineRange& range, MessageLines messages, MessageLog& log,
              Parentheses parentheses = Parentheses::brackets);

/// True if the line ends with a backslash inside parentheses. `depth`: how many were open before, and are
/// after.
bool goesOnInParentheses(std::string_view text, const LineRange& range, int& depth);

/// The first two words of a line, as far as they show what the line is; nothing is reported. A word ends
/// where the lexer ends it.
struct LineStart {
    std::string_view word;
    std::string_view next;
};
LineStart startOf(std::string_view text, const LineRange& range);

}  // namespace glibra::glib
