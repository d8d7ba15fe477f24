#pragma once
// Reads the arguments of a modern statement as its row describes them.

#include <span>
#include <string_view>

#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/parse/mismatch.h"
#include "glib/script.h"
#include "glib/statement_table.h"

namespace glibra::glib {

/// Fills `values`, `keys` and `tags` of the command from the tokens. `text` is the whole scene. Reports at
/// most one error: glib-E15 to E20, E24, E31, E37.
void readStatement(const StatementRow& row, std::string_view text, std::span<const Token> tokens,
                   const DeclaredNames& names, Command& command, MessageLog& log);

/// True if a bracket of the tokens of a Program statement, or a tag, has a word or a malformed number as its
/// value.
bool hasMalformedValue(std::span<const Token> tokens);

}  // namespace glibra::glib
