#pragma once
// The arguments of a statement as its row in the command table wants them (language, 1.5 to 1.7 and 3).

#include <cstddef>
#include <span>
#include <vector>

#include "glib/command_table.h"
#include "glib/lexer.h"
#include "glib/message_log.h"
#include "glib/script.h"
#include "glib/statement.h"

namespace glibra::glib {

/// A number token: its value and its text without what was ignored.
struct ReadNumber {
    double value = 0;
    std::string_view text;
};

/// Any token as a number. Reports glib-W04, W05, E05.
ReadNumber readNumber(const Token& token, MessageLog& log);

/// The tokens without brackets, which mean nothing around plain arguments. Reports glib-W10, W08, W09.
std::vector<Token> plainArguments(const Statement& statement, MessageLog& log);

/// Reads one token as this argument, checked against the argument's rule; `where` names the command in
/// messages. Reports what readNumber reports, glib-W26, W27, W28, E05, E12, E15.
double readArgument(const Argument& argument, std::size_t index, const Token& token, std::string_view command,
                    MessageLog& log);

/// Reports glib-W07 for the tokens from `used` on.
void reportSurplus(const Statement& statement, std::span<const Token> tokens, std::size_t used,
                   MessageLog& log);

/// Fills `command` from the statement. One function a family of forms; all report their own errors to the
/// log.
void readNumbers(const Statement& statement, Command& command, MessageLog& log);      // ArgumentForm::numbers
void readFile(const Statement& statement, Command& command, MessageLog& log);         // file
void readCubeMap(const Statement& statement, Command& command, MessageLog& log);      // cubeMap
void readUnits(const Statement& statement, Command& command, MessageLog& log);        // units
void readTexture(const Statement& statement, Command& command, MessageLog& log);      // texture
void readTopology(const Statement& statement, Command& command, MessageLog& log);     // topology
void readSwitch(const Statement& statement, Command& command, MessageLog& log);       // switchWord
void readPointGroups(const Statement& statement, Command& command, MessageLog& log);  // pointGroups

/// What one command demands beyond its single arguments: Perspective, Ortho, Rotate, Scale. `places` are
/// those of the numbers that stand in the file. Reports glib-E05, W06 (Ortho), W28, W29.
void applyCommandRules(Command& command, std::span<const Position> places, MessageLog& log);

}  // namespace glibra::glib
