#pragma once
// Reads the options of a picture (option_table.h) from a suite.

#include <filesystem>

#include "suite/file/shot_template.h"
#include "suite/file/toml_reader.h"
#include "suite/options/option_table.h"

namespace glibra::suite {

/// Gives `shot` the value of one option. Uniform variables and objects' matrices are set one by one; other
/// values are replaced as a whole. Folders are relative to `folder`. A wrong value is reported and changes
/// nothing.
void readOption(TomlReader& reader, const OptionRow& row, const TomlValue& value,
                const std::filesystem::path& folder, ShotTemplate& shot);

}  // namespace glibra::suite
