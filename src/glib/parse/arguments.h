#pragma once
// Reads the arguments of a statement as its row in the command table describes them (language, 1.5 to 1.7 and
// 3).

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "glib/command_table.h"
#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/parse/statement.h"
#include "glib/script.h"

namespace glibra::glib {

/// Returns the tokens without brackets, which have no meaning around plain arguments. Reports glib-W10, W08,
/// W09.
std::vector<Token> plainArguments(const Statement& statement, MessageLog& log);

/// Reads one token as this argument and checks it against the argument's rule. `command` is the command's
/// name for messages. Reports what readNumber reports, and glib-W26, W27, W28, W42, E05, E12, E15.
double readArgument(const Argument& argument, std::size_t index, const Token& token, std::string_view command,
                    MessageLog& log);

/// Reports glib-W07 for the tokens from `used` on.
void reportSurplus(const Statement& statement, std::span<const Token> tokens, std::size_t used,
                   MessageLog& log);

/// One number of a command whose arguments are evaluated: its value, and the place of the number or
/// expression that gave it.
struct EvaluatedNumber {
    double value = 0;
    Position position;
    bool reportsCut = false;  ///< a fraction where an integer is wanted is reported: glib-W27
};

/// Fills `numbers` of a command that is evaluated later, by the rules of its row, as if the file stated the
/// numbers. Reports what readNumbers reports about them, and glib-E31 for values that are not finite.
void evaluateNumbers(const CommandRow& row, Command& command, std::span<const EvaluatedNumber> numbers,
                     MessageLog& log);

/// Each of these fills `command` from the statement, for one of the argument forms, and reports its errors to
/// the log.
// ArgumentForm::numbers; `values` instead, if an expression is among them
void readNumbers(const Statement& statement, Command& command, MessageLog& log);
void readFile(const Statement& statement, Command& command, MessageLog& log);         // file
void readCubeMap(const Statement& statement, Command& command, MessageLog& log);      // cubeMap
void readUnits(const Statement& statement, Command& command, MessageLog& log);        // units
void readTexture(const Statement& statement, Command& command, MessageLog& log);      // texture
void readTopology(const Statement& statement, Command& command, MessageLog& log);     // topology
void readSwitch(const Statement& statement, Command& command, MessageLog& log);       // switchWord
void readPointGroups(const Statement& statement, Command& command, MessageLog& log);  // pointGroups

/// Fills `text` and `uniforms`. `fragmentFile` is the current fragment shader as written; a program without a
/// name is named after it. Reports glib-W04, W05, W08, W09, W10, W14 to W19, E15, E31. glib-W15 is reported
/// here only where the type of the uniform does not matter: for colours and ranges of one or two values, and
/// for those with too many.
void readProgram(const Statement& statement, std::string_view fragmentFile, Command& command,
                 MessageLog& log);

/// True if a tag has a subscript that a member or a value follows: `lights[1].color {1 0 0}`, `weights[2]
/// .5`. Classic scenes read such a subscript as the value.
bool hasSubscriptedTag(std::span<const Token> tokens);

/// Moves the tags of a modern Program whose values are plain numbers to `uniforms`, as readProgram fills it;
/// with `takesParts` also those with members and constant subscripts.
void takeUniforms(Command& command, bool takesParts = false);

}  // namespace glibra::glib
