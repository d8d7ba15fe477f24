#pragma once
// The words of the language: the names of the statements, and one row per statement.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::glib {

/// The statements of the language; aliases have the id of their statement. Each has one row in
/// statement_rows.cpp, the stages and Program one for each form. Primitives have no names here: their ids are
/// firstPrimitive + index into geometry::primitives().
// clang-format off
enum class CommandId {
    // window, view, colour
    windowSize, perspective, ortho, lookAt, color, background, clear,
    translate, rotate, scale, pushMatrix, popMatrix,
    // geometry
    obj, wireObj, objAdj, objPatch, shp, linesAdjacency, triangles,
    glBegin, glVertex, glNormal, glColor, glTexCoord, glEnd,
    lineWidth, pointSize, pointSizeMode, numPatchVertices, flat, smooth,
    // textures and targets
    texture1D, texture2D, texture3D, texture, cubeMap, renderToTexture, clamp,
    // shaders and programs
    vertex, tessControl, tessEvaluation, geometry, fragment, program,
    geometryInput, geometryOutput, geometryVerticesOut, gstap,
    // noise, time, messages
    noise2D, noise3D, timer, messageBox, verbose,
    // modern statements
    let, bound, set, material, light, group, endGroup, draw, repeat, endRepeat, when, elseBranch, endWhen,
    include, glslText, use, key, multMatrix, fps, camera,
    namedTexture1D, namedTexture2D, namedTexture3D, textureArray1D, textureArray, textureRect, namedCubeMap, sampler,
    pass, endPass, fill, clearParts, viewport, scissor, state, instances, vertices, attribute, tessLevels,
    buffer, mesh, compute, dispatch, once, endOnce, step, endStep, expect, print,
    firstPrimitive,
};
// clang-format on

}  // namespace glibra::glib

// The words of the language: one row per statement. Parser, reference, suggestions, editor grammar and tests
// read the rows.
//
// A row states the syntax after the statement's word in a small notation, which syntax.h compiles:
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
//
// Classic statements have no keys. Their numbers may say more:
//
//   name:type=5     5 replaces a missing number without a message
//   name:type~0     0 replaces a missing number with glib-W06; after =5, only if another number is given
//   name:type/1..9  the limits, numbers or names of limits; what happens beyond them is said by the type
//   name:.../pixels the unit

namespace glibra::geometry {
struct PrimitiveSpec;
}

namespace glibra::glib {

struct Command;
struct Position;
class MessageLog;

/// The clear colour until a scene sets one, and that of a Background without numbers.
inline constexpr std::array<double, 3> kDefaultBackground{18 / 255., 27 / 255., 33 / 255.};

/// What a statement does to the blocks of the script.
enum class BlockRole : std::uint8_t { none, opens, divides, closes };

/// Where a statement may stand.
enum class Standing : std::uint8_t {
    anywhere,
    declaration,  ///< outside Group, Repeat, When, Once and Step
    outermost,    ///< outside all blocks
    notInPass,    ///< outside Pass
};

/// What a single number of a classic statement means where the row has several.
enum class LoneNumber : std::uint8_t {
    first,       ///< the first argument
    firstThree,  ///< the first three arguments
    grey,        ///< the first three arguments, with glib-W06
};

struct StatementRow {
    CommandId id{};
    std::string_view name{};
    std::string_view syntax{};
    std::string_view summary{};  ///< one line
    std::string_view alias{};
    /// Checks and mends all numbers together. `places` are those of the numbers that stand in the file.
    void (*together)(Command&, std::span<const Position> places, MessageLog&) = nullptr;
    LoneNumber loneNumber = LoneNumber::first;
    BlockRole role = BlockRole::none;
    CommandId opener{};  ///< of the block that the statement divides or closes
    Standing standing = Standing::anywhere;
    bool declaresName = false;  ///< its first value is a new name of the namespace of objects
    bool takesBody = false;     ///< the word `inline` in it begins GLSL, up to End and the statement's name
    bool restartsSimulation = true;  ///< false for what acts on the frame alone outside of Once and Step

    [[nodiscard]] std::array<std::string_view, 2> names() const { return {name, alias}; }

    /// True if a classic and a modern statement have the word, so that the arguments decide which of them it
    /// is.
    [[nodiscard]] bool sharesWord() const;
};

/// All classic statements, in the order of the language's section 3.
std::span<const StatementRow> commandTable();

/// All modern statements, in the order of the specification.
std::span<const StatementRow> statementTable();

/// The row of a classic word or alias, in any case; null if there is none.
const StatementRow* findCommand(std::string_view word);

/// The id of a classic statement that exists, by its word or alias.
CommandId commandOf(std::string_view word);

/// The row of a word that only modern statements have, in any case; null if there is none.
const StatementRow* findStatement(std::string_view word);

/// The modern form of a word that a classic statement has as well; null if there is none.
const StatementRow* modernFormOf(std::string_view word);

/// The modern row of an id; null if the id has none. The stages in the script have the ids of the classic
/// stages.
const StatementRow* statementOf(CommandId id);

/// The row of the primitive; null if the statement is not one.
const geometry::PrimitiveSpec* primitiveOf(CommandId id);

/// False for what acts on the frame alone where it stands outside of Once and Step. The window does not start
/// a simulation again if such a statement changes.
bool restartsSimulation(CommandId id);

/// The word of a statement, as the reference spells it.
std::string_view nameOf(CommandId id);

/// The word or alias nearest to an unknown word, spelled as in its table; empty if none is near.
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

/// A format of the empty textures of classic statements: its word and the bytes of one texel.
struct TextureFormat {
    std::string_view name;
    int bytes = 4;
};
/// RGBA8 (the default) first.
std::span<const TextureFormat> textureFormats();

}  // namespace glibra::glib
