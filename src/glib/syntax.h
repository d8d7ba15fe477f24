#pragma once
// The syntax of a statement, compiled from the notation of its row (statement_table.h).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glib/statement_table.h"

namespace glibra::glib {

enum class ValueType : std::uint8_t {
    number,  ///< a number or an expression
    // Numbers of classic statements with rules of their own (language, 1.7). `number` is every finite number.
    size,       ///< negative: the absolute value is used (glib-W28); 0: the shape draws nothing (glib-W42)
    count,      ///< an integer; below `low`: raised to it (glib-W28); above `high`: glib-E15
    integer,    ///< outside low..high: glib-E05
    between,    ///< not strictly between low and high: glib-E05
    positive,   ///< not above 0: glib-E05; outside low..high: glib-E15
    component,  ///< of a colour; outside 0..1: kept (glib-W26)
    // Numbers that say how the other arguments are read.
    texels,  ///< an integer; negative: as a size; 0: glib-E05; above `high`: glib-E15
    unit,    ///< an integer, a texture unit; outside low..high: glib-E12
    // Arguments of modern statements, and words of classic ones.
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
    // Other arguments of classic statements.
    points,  ///< groups of three or four numbers; their number is a multiple of `most`
    truth,   ///< on, off, 1, 0, true, false
    line,    ///< the raw text to the end of the line
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
    bool repeats = false;                     ///< followed by ...
    bool needsOne = false;                    ///< a set or pairs that may not be empty
    bool isSkippable = false;                 ///< inside [ ] or { }
    bool isChosen = false;                    ///< inside ( | )
    std::optional<double> byDefault, filler;  ///< what replaces a missing number (statement_table.h)
    double low = 0, high = 0;                 ///< limits of a number
    std::string measure;                      ///< "pixels", "degrees", "seconds" or nothing
    std::vector<SyntaxNode> children;
};

struct Syntax {
    SyntaxNode root;
    std::vector<const SyntaxNode*> arguments;  ///< the values and pairs in order
    std::vector<std::string> keys;             ///< all keys, each once, without suffixes
    std::vector<std::string> outerKeys;        ///< those that may stand without another key before them
};

/// The compiled syntax of a row of the tables.
const Syntax& syntaxOf(const StatementRow& row);

/// The values and pairs of a syntax in order. Those that may be left out are isSkippable.
inline std::span<const SyntaxNode* const> argumentsOf(const StatementRow& row) {
    return syntaxOf(row).arguments;
}

/// The type of the last argument, which says how a classic statement is read; `number` if there is none.
inline ValueType lastTypeOf(const StatementRow& row) {
    return argumentsOf(row).empty() ? ValueType::number : argumentsOf(row).back()->type;
}

/// True for a classic statement of numbers alone, or without arguments.
inline bool takesNumbers(const StatementRow& row) {
    return lastTypeOf(row) <= ValueType::component;
}

/// True if the syntax has such a node.
bool hasNode(const StatementRow& row, const std::function<bool(const SyntaxNode&)>& isSuch);

}  // namespace glibra::glib
