#pragma once
// Reads the arguments of a modern statement as its row describes them.

#include <functional>
#include <span>
#include <string_view>

#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/modern/statement_table.h"
#include "glib/script.h"

namespace glibra::glib {

/// What is known about names. A misspelt key is not a declared name.
struct DeclaredNames {
    std::function<bool(std::string_view name)> has;      ///< declared before the statement
    std::function<bool(std::string_view name)> mayHave;  ///< the same, or an included file may declare it
};

/// Fills `values`, `keys` and `tags` of the command from the tokens. `text` is the whole scene. Reports at
/// most one error: glib-E05, E15 to E20, E24.
void readStatement(const StatementRow& row, std::string_view text, std::span<const Token> tokens,
                   const DeclaredNames& names, Command& command, MessageLog& log);

}  // namespace glibra::glib
