#pragma once
// The syntax of a modern statement, compiled from the notation of its row (statement_table.h).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "glib/modern/statement_table.h"

namespace glibra::glib {

enum class ValueType : std::uint8_t {
    number,      ///< a number or an expression
    name,        ///< a new name: letters, digits and _
    array,       ///< a new name, or name[count]
    object,      ///< the name of an object with parts: slice[i], life.prev, glow.level(2)
    word,        ///< any unquoted word
    file,        ///< a word, or a text in quotes
    program,     ///< a word, or a text in quotes
    key,         ///< a word, a number or a text in quotes
    any,         ///< any value but a text in quotes
    constant,    ///< any value but a text in quotes and a name
    expression,  ///< ( ... )
    list,        ///< [...]
    words,       ///< [...] without `of`
    color,       ///< {r g b} or an expression
    components,  ///< {...}, [...] or an expression
    oneOf,       ///< one of `words`, or an expression
};

/// One node of a syntax.
struct SyntaxNode {
    enum class Kind : std::uint8_t { key, value, sequence, choice, optional, set, pairs };
    Kind kind = Kind::sequence;
    std::string text;                ///< of a key; the name of a value
    bool hasNumberSuffix = false;    ///< a key that .NUMBER may follow
    std::vector<std::string> words;  ///< of a value of type oneOf; the suffixes of a key
    ValueType type = ValueType::number;
    std::size_t least = 1;  ///< how many numbers
    std::size_t most = 1;
    bool repeats = false;      ///< followed by ...
    bool needsOne = false;     ///< a set or pairs that may not be empty
    bool isSkippable = false;  ///< inside [ ] or { }
    bool isChosen = false;     ///< inside ( | )
    std::vector<SyntaxNode> children;
};

struct Syntax {
    SyntaxNode root;
    std::vector<std::string> keys;       ///< all keys, each once, without suffixes
    std::vector<std::string> outerKeys;  ///< those that may stand without another key before them
};

/// The compiled syntax of a row of the table.
const Syntax& syntaxOf(const StatementRow& row);

/// True if the syntax has such a node.
bool hasNode(const StatementRow& row, bool (*isSuch)(const SyntaxNode&));

}  // namespace glibra::glib
