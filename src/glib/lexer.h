#pragma once
// Splits a text into lines and tokens (language, 1.1, 1.2, 1.4). Tokens point into the text, which must
// outlive them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "glib/messages.h"
#include "glib/script.h"

namespace glibra::glib {

/// What parentheses mean on a line.
enum class Parentheses : std::uint8_t {
    brackets,     ///< they are always brackets
    byContent,    ///< an expression, if they hold a word or an operator; else brackets (classic commands)
    expressions,  ///< always an expression (modern statements)
};

/// The pairs of parentheses of one line.
class ExpressionFinder {
  public:
    /// Looks at `code` from offset `from` up to the first comment. Takes time in proportion to the line.
    ExpressionFinder(std::string_view code, std::size_t from);

    /// Returns the offset after the partner of the parenthesis at `open`, if the pair is an expression; 0 if
    /// it is not.
    [[nodiscard]] std::size_t endAt(std::size_t open, Parentheses parentheses) const;

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    void look(std::string_view code);

    std::size_t from_;
    std::vector<std::size_t> partner_;   ///< by offset - from_; kNone: no parenthesis, or not closed
    std::vector<std::size_t> nextSign_;  ///< offset of the next word or operator at or after this one
};

/// How deep the parentheses of the text are nested.
std::size_t depthOf(std::string_view expression);

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

// ---- Bracket groups (language, 1.6), and lines that can be read as tags and values (1.3).

enum class GroupEnd {
    closed,        ///< by its own bracket
    wrongBracket,  ///< by another closing bracket (glib-W08)
    notClosed,     ///< before a word, an opening bracket or the end of the statement (glib-W09)
};

/// tokens[first .. last) are the content; tokens[next] is the first token after the group.
struct BracketGroup {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t next = 0;
    GroupEnd end = GroupEnd::closed;
};

/// Returns the group that begins with the opening bracket tokens[open]. Words that begin with a letter or '_'
/// end it, except `true` and `false`; all other tokens are values.
BracketGroup groupAt(std::span<const Token> tokens, std::size_t open);

/// Returns the index after the value that begins with tokens[at], a number or an opening bracket.
std::size_t valueEnd(std::span<const Token> tokens, std::size_t at);

/// True for `word value { word [value] }`.
bool readsAsPairs(std::span<const Token> tokens);

/// True if `close` is the bracket that belongs to `open`.
bool bracketsMatch(std::string_view open, std::string_view close);

/// Reports glib-W08 and W09 for a group.
void reportGroupEnd(std::span<const Token> tokens, std::size_t open, const BracketGroup& group,
                    MessageLog& log);

}  // namespace glibra::glib
