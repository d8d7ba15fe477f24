#pragma once
// The name and the tags of a Program statement (language, 5.1 and 5.2).

#include <string_view>

#include "glib/message_log.h"
#include "glib/script.h"
#include "glib/statement.h"

namespace glibra::glib {

/// Fills `text` and `uniforms`. `fragmentFile` is the current one as written: a program without a name gets
/// its name from it. Reports glib-W04, W05, W08, W09, W10, W14 to W19, E05, E15; of glib-W15 what needs no
/// type: colours of one or two values, ranges of one or two, ranges and colours of too many.
void readProgram(const Statement& statement, std::string_view fragmentFile, Command& command,
                 MessageLog& log);

}  // namespace glibra::glib
