#pragma once
// Private to this folder: the items of [ ], { } and < > are values, so words and malformed numbers among them
// are reported.

#include <span>
#include <vector>

#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/modern/build_command.h"
#include "glib/modern/declared_names.h"
#include "glib/modern/pieces.h"
#include "glib/modern/statement_table.h"

namespace glibra::glib {

/// Reports glib-E19 for the first item of a statement that is no value. The words that Repeat runs over and
/// those of a choice stay.
void checkItems(const StatementRow& row, const std::vector<Event>& events, const Pieces& pieces,
                const DeclaredNames& names, MessageLog& log);

/// True if a bracket of the tokens of a Program statement, or a tag, has a word or a malformed number as its
/// value.
bool hasMalformedValue(std::span<const Token> tokens);

}  // namespace glibra::glib
