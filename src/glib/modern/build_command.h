#pragma once
// Private to this folder: what the syntax of a statement has read becomes the values, keys and tags of its
// command.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "glib/message_log.h"
#include "glib/modern/grammar.h"
#include "glib/modern/pieces.h"
#include "glib/modern/statement_table.h"
#include "glib/script.h"

namespace glibra::glib {

/// What a part of the syntax has read: a key, values, or a tag, whose value is the next event.
struct Event {
    enum class Kind : std::uint8_t { key, value, tag };
    Kind kind = Kind::value;
    const SyntaxNode* node = nullptr;
    std::size_t begin = 0;  ///< pieces
    std::size_t end = 0;
    std::string resembles{};  ///< KeyedValues::resembles
};

/// Fills `values`, `keys` and `tags` of the command. Reports glib-E15 for too many tags and glib-E18 for a
/// tag that is given twice.
void build(const StatementRow& row, const std::vector<Event>& events, Pieces pieces, Command& command,
           MessageLog& log);

}  // namespace glibra::glib
