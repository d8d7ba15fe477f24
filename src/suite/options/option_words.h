#pragma once
// Options as words of a command line.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "image/compare/judge.h"
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

// The keys of `tolerance` in a suite, for those who read and those who propose one.

struct ToleranceKey {
    std::string_view key;
    double most;  ///< the least is 0
    std::optional<double> (*get)(const image::Tolerance&);
    void (*set)(image::Tolerance&, double);
    bool isWhole = false;
};
std::span<const ToleranceKey> toleranceKeys();

/// "tolerance = { cluster = 12, bias = 1.3 }", a line for the [[shot]]. If the suite states a tolerance for
/// the shot, the line has all its keys, since it takes the place of what the shot has and is merged with
/// [defaults]; otherwise those that differ from the defaults.
std::string toleranceLine(const image::Tolerance& tolerance, bool isStated, bool isFloat);

}  // namespace glibra::suite
