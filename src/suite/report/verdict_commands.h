#pragma once
// The command lines that a report offers.

#include <string>
#include <string_view>

#include "suite/suite.h"

namespace glibra::suite {

/// As one word of a POSIX shell; quoted only where it has to be.
std::string shellWord(std::string_view text);
/// The options of `glibra render` that give a picture that view, each with a blank before it; empty for the
/// scene's own.
std::string viewArguments(const ViewState& view);
/// Renders the shot into the current folder.
std::string reproduceCommand(const Shot& shot);
/// Makes the shot's picture the new golden.
std::string acceptCommand(const Suite& suite, const Shot& shot);

}  // namespace glibra::suite
