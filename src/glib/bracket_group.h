#pragma once
// Finds the end of a bracket group (language, 1.6), and decides whether a line can be read as tags and values
// (1.3).

#include <cstddef>
#include <span>

#include "glib/lexer.h"

namespace glibra::glib {

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
