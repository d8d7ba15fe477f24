#pragma once
// The options of a picture (suite/options/option_table.h) on a command line.

#include <string>
#include <string_view>
#include <vector>

#include "suite/suite.h"

namespace glibra::cli {

class CommandLine;
class Option;

/// Adds the option of one row; `name` is without "--". `to` must outlive the command.
void addPictureOption(CommandLine& command, std::string_view name, suite::Shot& to);
/// Adds all rows that have a name.
void addPictureOptions(CommandLine& command, suite::Shot& to);
/// Prints what is wrong with the values of --set; false if one of them cannot be read.
bool acceptsSet(const std::vector<std::string>& set);
/// Makes `suite`, the option --suite, exclude the options that a suite states itself.
void excludePictureOptions(CommandLine& command, Option& suite);

}  // namespace glibra::cli
