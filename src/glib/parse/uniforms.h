#pragma once
// The name and the tags of a Program statement (language, 5.1 and 5.2).

#include <span>
#include <string_view>

#include "glib/message_log.h"
#include "glib/parse/statement.h"
#include "glib/script.h"

namespace glibra::glib {

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
