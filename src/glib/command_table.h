#pragma once
// The words of the language: one row a command, which feeds the parser, --help, the reference and the editor
// grammar.

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "glib/command_id.h"

namespace glibra::glib {

/// The clear colour until a scene sets one, and that of a Background without numbers.
inline constexpr std::array<double, 3> kDefaultBackground{18 / 255., 27 / 255., 33 / 255.};

enum class ArgumentType { number, integer, file, word, text, name, pointGroups, uniforms };

/// What happens to a number that an argument cannot take as it is (language, 1.7).
enum class ArgumentRule {
    any,        ///< nothing: every finite number is taken
    size,       ///< negative: its absolute value; 0 draws nothing (glib-W28)
    count,      ///< below `least`: raised to it (glib-W28); above `most`: glib-E15
    within,     ///< outside least..most: glib-E05
    between,    ///< not strictly between least and most: glib-E05
    positive,   ///< not above 0: glib-E05; outside least..most: glib-E15
    texels,     ///< as `size`, but 0 is glib-E05; above `most`: glib-E15
    component,  ///< of a colour; outside 0..1: kept (glib-W26)
    unit,       ///< of a texture; outside 0..127: glib-E12
};

/// One argument. Numbers that are left out become `byDefault` in silence, or `filler` with glib-W06; without
/// either they are glib-E04, unless `optional` says that Command::numbers simply ends before them.
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
    numbers,   ///< `numbers`
    file,      ///< one file name or none: `text`
    cubeMap,   ///< unit and six files: `numbers`, `files`
    units,     ///< up to eight texture units: `numbers`
    texture,   ///< unit and file or sizes and format: `numbers` (unit, sizes), `text` (file; format if there
               ///< are sizes)
    topology,  ///< one of `words`, with or without gl_: `text`, without gl_, in lower case
    switchWord,   ///< on, off, 1, 0, true, false: `numbers` (1 or 0), `text`
    message,      ///< raw text to the end of the line: `text`
    pointGroups,  ///< `points`, a multiple of `groupMultiple`
    program,      ///< name and pairs: `text`, `uniforms`
};

/// What a single number stands for where the row has more than one.
enum class LoneNumber {
    first,       ///< itself
    firstThree,  ///< the first three arguments
    grey,        ///< the first three arguments, by a tolerance (glib-W06)
};

struct CommandRow {
    CommandId id{};
    ArgumentForm form = ArgumentForm::numbers;
    std::array<std::string_view, 2> names{};  ///< as the reference spells it, and an alias or nothing
    std::span<const Argument> arguments{};
    std::string_view summary{};  ///< one line
    LoneNumber loneNumber = LoneNumber::first;
    int groupMultiple = 0;                      ///< of ArgumentForm::pointGroups
    std::span<const std::string_view> words{};  ///< of ArgumentForm::topology

    [[nodiscard]] std::string_view name() const { return names[0]; }
};

/// All commands, in the order of the language's section 3.
std::span<const CommandRow> commandTable();

/// The row of a command word or alias, in any case; null if there is none.
const CommandRow* findCommand(std::string_view word);

/// The command's word, as the reference spells it.
std::string_view nameOf(CommandId id);

/// The command or alias that lies nearest to an unknown word, spelled as in the table; empty if none is near.
std::string_view nearestCommand(std::string_view word);

/// Formats of empty textures: the word and the bytes of one texel.
struct TextureFormat {
    std::string_view name;
    int bytes = 4;
};
/// RGBA8 (the default) first.
std::span<const TextureFormat> textureFormats();

}  // namespace glibra::glib
