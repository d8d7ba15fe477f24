#pragma once
// Options as words of a command line.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "suite/options/option_table.h"

namespace glibra::suite {

/// Gives the shot the value that the text of an option states (empty for a flag). Options that may be
/// repeated add theirs. Returns what is wrong, as "expected a whole number from 1 to 64, found 'many'";
/// nothing was changed then. Empty if nothing is wrong.
std::string readOptionText(const OptionRow& row, std::string_view text, Shot& shot);

/// The words that give a shot this option, as {"--size", "800x600"}; empty for the default, for an option
/// without effect, and for one that has no name.
std::vector<std::string> optionWords(const OptionRow& row, const Shot& shot);

/// All options as one text for a POSIX shell, with a blank before each word.
std::string optionArguments(const Shot& shot);

/// Bytes from "512M" or "2G" (K, M, G, T: powers of 1024); nothing if it is not kMemoryForm.
std::optional<std::uint64_t> parseMemory(std::string_view text);
inline constexpr std::string_view kMemoryForm = "a size from 64M, as 512M or 2G, or 0";
/// The shortest text that parseMemory() reads as these bytes.
std::string memoryText(std::uint64_t bytes);

using base::shellWord;

// Options as the text of a suite.

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
