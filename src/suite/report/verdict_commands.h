#pragma once
// The commands that a report offers.

#include <string>

#include "suite/suite.h"

namespace glibra::suite {

/// The command that renders the shot to a file in the current folder.
std::string reproduceCommand(const Shot& shot);
/// The command that makes the shot's picture the new golden.
std::string acceptCommand(const Suite& suite, const Shot& shot);

}  // namespace glibra::suite
