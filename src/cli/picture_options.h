#pragma once
// The options of a picture (suite/options/option_table.h) on a command line.

#include <string_view>

#include "suite/suite.h"

namespace glibra::cli {

class CommandLine;
class Option;

/// Adds the option of one row; `name` is without "--". `to` must outlive the command.
void addPictureOption(CommandLine& command, std::string_view name, suite::Shot& to);
/// Adds all rows that have a name.
void addPictureOptions(CommandLine& command, suite::Shot& to);
/// Makes `suite`, the option --suite, exclude the options that a suite states itself.
void excludePictureOptions(CommandLine& command, Option& suite);

}  // namespace glibra::cli
