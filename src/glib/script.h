#pragma once
// A scene's text as a list of commands and their arguments.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "glib/statement_table.h"

namespace glibra::glib {

// The arguments of modern statements, as written. Nothing is evaluated here: an expression is its text.

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

// A scene's text as a list of commands. The parser makes it, the interpreter reads it.

/// How the value of a uniform is written on a Program line (language, 5.2).
enum class UniformForm { number, list, range, truth, color };

/// One `tag value` pair of a Program statement. `values` are the numbers as written (for truth: 1 or 0).
/// Their meaning depends on the type in the linked program; src/plan decides it.
struct UniformSpec {
    std::string tag;
    UniformForm form = UniformForm::number;
    std::vector<double> values;
    Position tagPosition;
    Position valuePosition;
    bool mayBeUnknown = false;  ///< set for all draws of a scope: a program without the uniform is no mistake
    std::string resembles{};    ///< KeyedValues::resembles
    /// The word of a choice whose number `values` holds, or a word that may name a function of a subroutine
    /// uniform; then there are no values.
    std::string word{};
    bool changesWithTime = false;  ///< of a variable: another time may give it another value
};

/// One statement: its arguments, in the order of the file.
/// - values: what stands before the first key. Of a classic statement these are the arguments that are no
///   numbers: words as they are written (a file, the name of a program), with the format of an empty texture
///   filled in;
/// - numbers: those of a classic statement, in the order of its row, defaults filled in, inside their limits;
///   of LinesAdjacency and Triangles x, y, z, w of each point;
/// - keys: each key of a modern statement with the values that follow it;
/// - tags: the pairs of Set, Group, Draw, Fill and Program; those of Program whose value is a plain number,
///   list, colour or range are in `uniforms` instead;
/// - body: the text of a shader in the script.
///
/// A classic statement of numbers with an expression among them is `isEvaluatedLater`: `values` are its
/// numbers and expressions in order, and evaluateNumbers (parse/arguments.h) fills `numbers`.
///
/// All statements share this struct instead of having a type each: the parser, the formatter, the editor's
/// help and the window's edits go through the rows of the tables and know no statement, and only the function
/// that carries a statement out knows what its values are.
struct Command {
    CommandId id{};
    std::string word;  ///< as written
    Position position;
    std::size_t begin = 0;  ///< byte range of the statement in the file, for editing it in place
    std::size_t end = 0;

    std::vector<Value> values;
    std::vector<double> numbers;
    std::size_t givenNumbers = 0;  ///< how many of the numbers stand in the file
    std::vector<KeyedValues> keys;
    std::vector<KeyedValues> tags;
    std::vector<UniformSpec> uniforms;
    std::string body;
    Position bodyPosition;  ///< of the first byte of `body`
    bool isModern = false;
    bool isEvaluatedLater = false;
    bool lacksFile = false;  ///< it is faulty because it names no file, which a window may ask its user for
    /// The index of the command that ends this block; for a command that ends a block, of the one that opens
    /// it. The partner of When is its Else, if it has one; the partner of Else is EndWhen.
    std::size_t partner = kNoPartner;

    static constexpr std::size_t kNoPartner = static_cast<std::size_t>(-1);

    /// The text of the first value, and its place; empty if there is none.
    [[nodiscard]] std::string text() const { return values.empty() ? std::string() : values.front().text; }
    [[nodiscard]] Position textPosition() const {
        return values.empty() ? position : values.front().position;
    }
    /// The first key of this name; null if there is none.
    [[nodiscard]] const KeyedValues* key(std::string_view name) const;
};

/// True for `Let name(parameters) (expression)`, which declares a function of expressions.
bool declaresFunction(const Command& command);

/// A modern statement as a scene writes it, on one line (and the lines of its body); reading it again gives
/// an equal command. The uniforms of a Program are left out.
std::string written(const Command& command);

struct Script {
    std::string path;  ///< as given to the parser; used in every message
    std::vector<Command> commands;
    Diagnostics diagnostics;
    bool isModern = false;  ///< it has a modern statement or an expression
    /// What faulty statements would have declared: objects, variables, programs and groups. Whoever misses
    /// one of them reports nothing, since the faulty statement has been reported.
    std::set<std::string, std::less<>> lostNames;
    std::vector<Command> withoutFile;  ///< the faulty statements that lack a file (Command::lacksFile)

    [[nodiscard]] Place place(Position position) const { return {path, position.line, position.column}; }
};

/// Reads a whole scene (language, 1, 3 and 5.1). The text may hold any bytes. Parsing goes on to the end of
/// the text, so that all messages come at once; faulty statements are not in `commands`.
Script parse(std::string_view text, std::string path);

/// True if both have the same commands on the same lines, and the same messages, but for blanks after a
/// backslash (glib-W02).
bool meanTheSame(const Script& a, const Script& b);

}  // namespace glibra::glib
