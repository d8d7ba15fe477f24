#pragma once
// Joins lines to statements (language, 1.3).

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/statement_table.h"

namespace glibra::glib {

/// A command word with its arguments, from one or more lines.
struct Statement {
    const StatementRow* row = nullptr;  ///< of the classic statement; null: the word is none
    const StatementRow* modern =
        nullptr;  ///< not null: a modern statement; its word may be a classic one too
    Token word;
    std::vector<Token> arguments;
    std::size_t plainArguments = 0;  ///< how many of the arguments are not brackets
    std::string_view message;        ///< the text of MessageBox
    Position messagePosition;
    std::string_view body;  ///< of a shader in the script
    Position bodyPosition;
    std::size_t end = 0;   ///< byte offset after the statement's last token
    bool faulty = false;   ///< one of its lines has an error; it must not be run
    bool refused = false;  ///< not in this language (glib-E10); its arguments have no meaning
};

/// Reads a text statement by statement. Reports what the lexer reports and glib-W11, W12, W13, E10, E22.
class StatementReader {
  public:
    /// `isModern` says that the scene is known to have modern statements. Lines that would otherwise mean
    /// something in a classic scene are then modern statements.
    StatementReader(std::string_view text, bool isModern, MessageLog& log)
        : text_(text), lines_(text), isModern_(isModern), log_(log) {}

    /// Returns the next statement; nothing at the end of the text.
    std::optional<Statement> next();

    /// True if a line was read whose meaning depends on `isModern`.
    [[nodiscard]] bool wasAmbiguous() const { return wasAmbiguous_; }

  private:
    const Line* peek(const Statement* pending = nullptr);
    const StatementRow* modernRowOf(const Statement& statement);
    void joinModernLines(Statement& statement, bool pending, Position backslash);
    void readBody(Statement& statement);
    bool refuseShader(Statement& statement);
    void skipShader();
    bool startsStatement(const Token& word);
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
    bool isModern_;
    bool wasAmbiguous_ = false;
    MessageLog& log_;
    std::optional<Line> ahead_;
    std::set<std::string> bodiesWithoutEnd_;  ///< the words of stages whose body was searched in vain
    bool braceNeverCloses_ = false;  ///< a search for the end of a brace block reached the end of the text
};

/// The statements of a text, as parse() reads them.
std::vector<Statement> statementsOf(std::string_view text);

}  // namespace glibra::glib
