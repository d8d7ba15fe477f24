#pragma once
// The modern statements: one row each. Parser, reference, suggestions and tests read the rows.
//
// A row states the syntax after the statement's word in a small notation, which modern/grammar.h compiles:
//
//   from            a key, matched in any case; `blend.#` may be followed by .NUMBER, `stencil.front,back` by
//   one
//                   of the words
//   name:type       a value; the types are those of ValueType, a comma list of words, or a $list of words
//   name:number*9   nine numbers; an expression may stand for several of them
//   name:number+3   one to three numbers
//   a...            one or more; [a]... none or more
//   [a]             may be left out
//   (a | b)         one of them
//   {a | b}         any number of them in any order, each once; {a | b}+ at least one
//   pairs, pairs+   `tag value` pairs
//   $name           a fragment of the table of fragments

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glib/command_id.h"

namespace glibra::glib {

/// What a statement does to the blocks of the script.
enum class BlockRole : std::uint8_t { none, opens, divides, closes };

/// Where a statement may stand.
enum class Standing : std::uint8_t {
    anywhere,
    declaration,  ///< outside Group, Repeat, When, Once and Step
    outermost,    ///< outside all blocks
    notInPass,    ///< outside Pass
};

struct StatementRow {
    CommandId id{};
    std::string_view name{};
    std::string_view syntax{};
    std::string_view summary{};  ///< one line
    BlockRole role = BlockRole::none;
    CommandId opener{};  ///< of the block that the statement divides or closes
    Standing standing = Standing::anywhere;
    bool declaresName = false;  ///< its first value is a new name of the namespace of objects
    bool takesBody = false;     ///< the word `inline` in it begins GLSL, up to End and the statement's name
    bool restartsSimulation = true;  ///< false for what acts on the frame alone outside of Once and Step

    /// True if a classic command has the same word, so that the arguments decide which of them it is.
    [[nodiscard]] bool sharesWord() const;
};

/// All modern statements, in the order of the specification.
std::span<const StatementRow> statementTable();

/// The row of a word that only modern statements have, in any case; null if there is none.
const StatementRow* findStatement(std::string_view word);

/// The modern form of a word that a classic command has as well; null if there is none.
const StatementRow* modernFormOf(std::string_view word);

/// The row of an id; null if the id has none. The stages in the script have the ids of the classic stages.
const StatementRow* statementOf(CommandId id);

/// False for what acts on the frame alone where it stands outside of Once and Step. The window does not start
/// a simulation again if such a statement changes.
bool restartsSimulation(CommandId id);

/// The word of a classic command or a modern statement, as the reference spells it.
std::string_view nameOf(CommandId id);

/// The command, alias or modern statement nearest to an unknown word, spelled as in its table; empty if none
/// is near.
std::string_view nearestCommand(std::string_view word);

/// The text that the notation's `$name` stands for; empty if there is no such fragment.
std::string_view syntaxFragment(std::string_view name);
/// The words of such a fragment that is a list of words, in their order.
std::vector<std::string_view> wordsOfFragment(std::string_view name);

/// The syntax as the reference shows it, with the statement's word and without types. A long list of words is
/// shown by its name.
std::string usage(const StatementRow& row);

/// The long lists of words in a syntax.
struct WordList {
    std::string name;
    std::vector<std::string> words;
};
std::vector<WordList> wordLists(const StatementRow& row);

/// All words that may stand as keys or as words of a list in a statement, each once.
std::vector<std::string> wordsOf(const StatementRow& row);

}  // namespace glibra::glib
