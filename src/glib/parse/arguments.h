#pragma once
// Reads the arguments of a statement as its row in the command table describes them (language, 1.5 to 1.7 and
// 3).

#include <cstddef>
#include <span>
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

/// Checks the numbers of Perspective, Ortho, Rotate and Scale together. `places` are the places of the
/// numbers that stand in the file. Reports glib-E05, E29, W06 (Ortho), W29, W42.
void applyCommandRules(Command& command, std::span<const Position> places, MessageLog& log);

}  // namespace glibra::glib
