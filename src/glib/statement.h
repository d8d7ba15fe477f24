#pragma once
// Joins lines to statements (language, 1.3).

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "glib/command_table.h"
#include "glib/lexer.h"
#include "glib/message_log.h"

namespace glibra::glib {

/// A command word with its arguments, from one or more lines.
struct Statement {
    const CommandRow* row = nullptr;  ///< null: the word is not a command
    Token word;
    std::vector<Token> arguments;
    std::size_t plainArguments = 0;  ///< how many of the arguments are not brackets
    std::string_view message;        ///< the text of MessageBox
    Position messagePosition;
    std::size_t end = 0;   ///< byte offset after the statement's last token
    bool faulty = false;   ///< one of its lines has an error; it must not be run
    bool refused = false;  ///< not in this language (glib-E10); its arguments have no meaning
};

/// Reads a text statement by statement. Reports what the lexer reports and glib-W11, W12, W13, E10.
class StatementReader {
  public:
    StatementReader(std::string_view text, MessageLog& log) : text_(text), lines_(text), log_(log) {}

    /// Returns the next statement; nothing at the end of the text.
    std::optional<Statement> next();

  private:
    const Line* peek();
    void drop() { ahead_.reset(); }
    const Line* peekCode();
    Statement begin();
    void joinLine(Statement& statement);
    bool continuesAfterBackslash(const Statement& statement);
    bool continuesWithoutBackslash(const Statement& statement);
    bool refuseBraceBlock(Statement& statement);
    bool skipBraceBlock();

    std::string_view text_;
    LineSplitter lines_;
    MessageLog& log_;
    std::optional<Line> ahead_;
    bool braceNeverCloses_ = false;  ///< a search for the end of a brace block reached the end of the text
};

}  // namespace glibra::glib
