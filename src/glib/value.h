#pragma once
// The arguments of modern statements, as written. Nothing is evaluated here: an expression is its text.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::glib {

/// A place inside the scene's own file.
struct Position {
    int line = 1;
    int column = 1;

    friend bool operator==(const Position&, const Position&) = default;
};

struct NamePart;

/// One value.
struct Value {
    enum class Kind {
        number,      ///< `number`
        word,        ///< `text`; `path` if it names an object
        text,        ///< quoted; `text` is without the quotes
        truth,       ///< `number` is 1 or 0
        expression,  ///< ( ... ); `text` is without the outer parentheses, byte for byte
        range,       ///< <min cur max> or <word word ...>; `items`
        color,       ///< {r g b} or {r g b a}; `items`
        list,        ///< [...]; `items`, or one item and `count`
    };
    Kind kind = Kind::number;
    double number = 0;
    std::string text;
    std::vector<Value> items;    ///< numbers, words and expressions
    std::vector<Value> count;    ///< [6 of (...)]: the value before `of`; otherwise empty
    std::vector<NamePart> path;  ///< slice[i].level(2) has two parts
    Position position;           ///< of the first byte, which is the bracket of a bracketed value
    std::size_t begin = 0;       ///< byte range in the file, with brackets and quotes
    std::size_t end = 0;
};

/// One part of a name: a word between points. `index` is empty or has the one value of its [k] or (k), which
/// is a number or an expression.
struct NamePart {
    std::string name;
    std::vector<Value> index;
};

/// A word that stands at this place.
inline Value wordOf(std::string_view text, Position position) {
    Value word;
    word.kind = Value::Kind::word;
    word.text = text;
    word.position = position;
    return word;
}

/// True for a number or an expression.
inline bool isNumeric(const Value& value) {
    return value.kind == Value::Kind::number || value.kind == Value::Kind::expression;
}

/// The name that a value begins with, without its parts and subscripts.
inline const std::string& headOf(const Value& value) {
    return value.path.empty() ? value.text : value.path.front().name;
}

/// A key of a statement, or a tag, with the values after it.
struct KeyedValues {
    std::string key;     ///< a key as the table of statements spells it; a tag as written, without blanks
    std::string suffix;  ///< the part of a key after its point: "1" of blend.1
    std::vector<NamePart> path;  ///< the parts of a tag, if it has a point or a subscript
    Position position;
    std::vector<Value> values;
    /// Of a tag: the key of the statement that it may be, misspelt. It is none if the program has the tag.
    std::string resembles{};
};

/// The place of a byte of an expression's text.
inline Position placeIn(const Value& expression, std::size_t offset) {
    return {expression.position.line, expression.position.column + 1 + static_cast<int>(offset)};
}

/// The value as a scene writes it; reading it again gives an equal value.
std::string written(const Value& value);

}  // namespace glibra::glib
