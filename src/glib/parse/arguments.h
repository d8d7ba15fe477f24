#pragma once
// Reads the arguments of a classic statement as its row describes them (language, 1.5 to 1.7 and 3).

#include <span>
#include <string_view>

#include "glib/lexer.h"
#include "glib/messages.h"
#include "glib/parse/statement.h"
#include "glib/script.h"
#include "glib/syntax.h"

namespace glibra::glib {

/// One number of a command whose arguments are evaluated: its value, and the place of the number or
/// expression that gave it.
struct EvaluatedNumber {
    double value = 0;
    Position position;
    bool reportsCut = false;  ///< a fraction where an integer is wanted is reported: glib-W27
};

/// Fills `numbers` of a command that is evaluated later, by the rules of its row, as if the file stated the
/// numbers. Reports what readNumbers reports about them, and glib-E31 for values that are not finite.
void evaluateNumbers(const StatementRow& row, Command& command, std::span<const EvaluatedNumber> numbers,
                     MessageLog& log);

/// Fills `command` from the statement, by its form; a program is read by readProgram. If an expression is
/// among numbers, fills `values` instead of `numbers`. Reports glib-W04 to W10, W26 to W29, W42, E04, E05,
/// E08, E12, E15, E16, E29, E31.
void readArguments(const Statement& statement, Command& command, MessageLog& log);

/// Fills `values` and `uniforms`. `fragmentFile` is the current fragment shader as written; a program without
/// a name is named after it. Reports glib-W04, W05, W08, W09, W10, W14 to W19, E15, E31. glib-W15 is reported
/// here only where the type of the uniform does not matter: for colours and ranges of one or two values, and
/// for those with too many.
void readProgram(const Statement& statement, std::string_view fragmentFile, Command& command,
                 MessageLog& log);

/// True if a tag has a subscript that a member or a value follows: `lights[1].color {1 0 0}`, `weights[2]
/// .5`. Classic scenes read such a subscript as the value.
bool hasSubscriptedTag(std::span<const Token> tokens);

/// Moves the tags of a modern Program whose values are plain numbers to `uniforms`, as readProgram fills it,
/// but those with computed subscripts.
void takeUniforms(Command& command);

}  // namespace glibra::glib
