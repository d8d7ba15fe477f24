#pragma once
// Options as the text of a suite.

#include <filesystem>
#include <string>
#include <string_view>

#include "suite/options/option_table.h"

namespace glibra::suite {

/// A basic string of TOML, with its quotes.
std::string tomlText(std::string_view text);
/// The same for a file, relative to `folder` where that is possible.
std::string tomlText(const std::filesystem::path& file, const std::filesystem::path& folder);

/// The line "key = value\n" that gives a shot this option; empty for the default and for an option that
/// suites cannot state. Files are written relative to `folder`.
std::string optionLine(const OptionRow& row, const Shot& shot, const std::filesystem::path& folder);

/// The lines of all options.
std::string optionLines(const Shot& shot, const std::filesystem::path& folder);

}  // namespace glibra::suite
