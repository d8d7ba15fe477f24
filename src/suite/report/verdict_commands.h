#pragma once
// The commands that a report offers.

#include <array>
#include <string>
#include <string_view>

#include "suite/suite.h"

namespace glibra::suite {

/// The command that renders the shot to a file in the current folder.
std::string reproduceCommand(const Shot& shot);
/// The options of pictures that `glibra check` has.
inline constexpr std::array<std::string_view, 13> kCheckOptions{
    "size",   "time",    "steps",           "set",      "eye", "samples", "library", "timeout", "memory",
    "strict", "no-shim", "check-undefined", "check-nan"};
/// The command that answers the checks of the shot's scene; empty if the shot has options that `glibra check`
/// lacks.
std::string checkCommand(const Shot& shot);
/// The command that moves the golden of the shot's former name.
std::string renameCommand(const Suite& suite, const Shot& shot);
/// The command that makes the shot's picture the new golden.
std::string acceptCommand(const Suite& suite, const Shot& shot);

}  // namespace glibra::suite
