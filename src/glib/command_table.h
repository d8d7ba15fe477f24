#pragma once
// The words of the language: one row per command. The parser, the reference and the editor grammar read it.

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "glib/command_id.h"

namespace glibra::geometry {
struct PrimitiveSpec;
}

namespace glibra::glib {

struct Command;
struct Position;
class MessageLog;

/// The clear colour until a scene sets one, and that of a Background without numbers.
inline constexpr std::array<double, 3> kDefaultBackground{18 / 255., 27 / 255., 33 / 255.};

enum class ArgumentType { number, integer, file, word, text, name, pointGroups, uniforms };

/// Which numbers an argument accepts, and what happens to others (language, 1.7).
enum class ArgumentRule {
    any,        ///< every finite number
    size,       ///< negative: the absolute value is used (glib-W28); 0: the shape draws nothing (glib-W42)
    count,      ///< below `least`: raised to it (glib-W28); above `most`: glib-E15
    within,     ///< outside least..most: glib-E05
    between,    ///< not strictly between least and most: glib-E05
    positive,   ///< not above 0: glib-E05; outside least..most: glib-E15
    texels,     ///< negative: the absolute value is used (glib-W28); 0: glib-E05; above `most`: glib-E15
    component,  ///< a colour component; outside 0..1: kept (glib-W26)
    unit,       ///< a texture unit; outside 0..127: glib-E12
};

/// One argument. A missing number is replaced by `byDefault` without a message, or by `filler` with glib-W06.
/// If the argument has neither, a missing number is glib-E04, unless `optional` is set: then
/// Command::numbers ends before it.
struct Argument {
    std::string_view name{};
    ArgumentType type = ArgumentType::number;
    std::optional<double> byDefault{};
    std::optional<double> filler{};
    bool optional = false;
    ArgumentRule rule = ArgumentRule::any;
    double least = 0;
    double most = 0;
    std::string_view unit{};  ///< "pixels", "degrees", "seconds" or nothing
};

/// How the text after the command word is read, and which members of Command it fills.
enum class ArgumentForm {
    numbers,      ///< fills `numbers`
    file,         ///< one file name or none: `text`
    cubeMap,      ///< a unit and six files: `numbers`, `files`
    units,        ///< up to eight texture units: `numbers`
    texture,      ///< a unit and a file: `numbers`, `text`; or a unit, sizes and a format: `numbers`, `text`
    topology,     ///< one of `words`, with or without gl_: `text`, without gl_, in lower case
    switchWord,   ///< on, off, 1, 0, true, false: `numbers` (1 or 0), `text`
    message,      ///< the raw text to the end of the line: `text`
    pointGroups,  ///< `points`, a multiple of `groupMultiple`
    program,      ///< a name and pairs: `text`, `uniforms`
};

/// What a single number means where the row has several arguments.
enum class LoneNumber {
    first,       ///< the first argument
    firstThree,  ///< the first three arguments
    grey,        ///< the first three arguments, with glib-W06
};

struct CommandRow {
    CommandId id{};
    std::array<std::string_view, 2> names{};  ///< the word as the reference spells it; an alias or nothing
    std::span<const Argument> arguments{};
    std::string_view summary{};  ///< one line
    ArgumentForm form = ArgumentForm::numbers;
    LoneNumber loneNumber = LoneNumber::first;
    int groupMultiple = 0;                      ///< for ArgumentForm::pointGroups
    std::span<const std::string_view> words{};  ///< for ArgumentForm::topology
    /// Checks and mends all numbers together. `places` are those of the numbers that stand in the file.
    void (*together)(Command&, std::span<const Position> places, MessageLog&) = nullptr;
    /// False for what acts on the frame alone where it stands outside of Once and Step.
    bool restartsSimulation = true;

    [[nodiscard]] std::string_view name() const { return names[0]; }
};

/// All classic commands, in the order of the language's section 3.
std::span<const CommandRow> commandTable();

/// The row of a command word or alias, in any case; null if there is none.
const CommandRow* findCommand(std::string_view word);

/// The id of a command that exists, by its word or alias.
CommandId commandOf(std::string_view word);

/// The row of the primitive; null if the command is not one.
const geometry::PrimitiveSpec* primitiveOf(CommandId id);

/// A format of empty textures: its word and the bytes of one texel.
struct TextureFormat {
    std::string_view name;
    int bytes = 4;
};
/// RGBA8 (the default) first.
std::span<const TextureFormat> textureFormats();

}  // namespace glibra::glib
