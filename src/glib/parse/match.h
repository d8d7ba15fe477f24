#pragma once
// Reads the arguments of a modern statement, and says why they do not fit.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/parse/pieces.h"
#include "glib/script.h"
#include "glib/statement_table.h"

namespace glibra::glib {

// Private to this folder: why the arguments of a statement do not fit its syntax. The syntax tries
// alternatives; the message is about the furthest argument that any of them arrived at.

/// What is known about names. A misspelt key is not a declared name.
struct DeclaredNames {
    std::function<bool(std::string_view name)> has;      ///< declared before the statement
    std::function<bool(std::string_view name)> mayHave;  ///< the same, or an included file may declare it
};

class Mismatch {
  public:
    /// Notes what an alternative expected at a piece; a suggestion can name a word. Returns false.
    bool expect(std::size_t at, Expectation expected);
    /// The same for a key or one of several words.
    bool expectWord(std::size_t at, const std::string& word);

    /// Notes that a piece repeats or contradicts an earlier one.
    void contradict(std::size_t before, std::size_t at);

    /// Reports one error: glib-E16 to E19. `matched`: the syntax fitted, but a piece at `at` is left over.
    /// `command` is the place of the statement.
    void report(const StatementRow& row, const Pieces& pieces, const DeclaredNames& names, bool matched,
                std::size_t at, Position command, MessageLog& log);

  private:
    using Kind = Expectation::Kind;

    [[nodiscard]] bool expects(Kind kind) const;
    [[nodiscard]] std::string listOfExpected() const;
    [[nodiscard]] std::string suggested(std::string_view word) const;
    /// What to write for the value of a name that stands without parentheses; empty if that is not the
    /// mistake.
    [[nodiscard]] std::string valueHint(const Pieces& pieces, std::size_t at,
                                        const DeclaredNames& names) const;
    /// For a statement whose name is missing before a word that may follow it; else empty.
    [[nodiscard]] std::string nameHint(const Pieces& pieces) const;
    /// For a word that is another command; else empty.
    [[nodiscard]] static std::string commandHint(const StatementRow& row, const Value& found);

    /// The brackets that are missing around the pieces from `at` on, or around an operator there; empty if
    /// none are.
    [[nodiscard]] std::string bracketHint(const Pieces& pieces, std::size_t at) const;
    /// The same for an argument that is too much.
    [[nodiscard]] std::string surplusHint(const Pieces& pieces, std::size_t at) const;

    std::size_t furthest_ = 0;
    std::vector<Expectation> expected_;
    std::optional<std::pair<std::size_t, std::size_t>> conflict_;  ///< the earlier and the later piece
};

// Reads the arguments of a modern statement as its row describes them.

/// Fills `values`, `keys` and `tags` of the command from the tokens. `text` is the whole scene. Reports at
/// most one error: glib-E15 to E20, E24, E31, E37.
void readStatement(const StatementRow& row, std::string_view text, std::span<const Token> tokens,
                   const DeclaredNames& names, Command& command, MessageLog& log);

/// True if a bracket of the tokens of a Program statement, or a tag, has a word or a malformed number as its
/// value.
bool hasMalformedValue(std::span<const Token> tokens);

}  // namespace glibra::glib
