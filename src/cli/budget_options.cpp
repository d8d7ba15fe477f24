// Options that give a picture a bound of error instead of counts.

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "cli/commands.h"

namespace glibra::cli {
namespace {

/// "0.25px" or "0.25".
double pixels(const std::string& text) {
    std::string_view number = text;
    if (number.ends_with("px")) number.remove_suffix(2);
    double value = 0;
    const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), value);
    // Written so that NaN is refused, too.
    if (problem != std::errc() || end != number.data() + number.size() ||
        !(value >= kLeastMaxError && value <= kLargestMaxError))
        throw CLI::ValidationError("--max-error",
                                   "'" + text + "' is not a number of pixels from 1e-9 to 1e6, as 0.25px");
    return value;
}

}  // namespace

void addBudgetOptions(CLI::App& command, RenderOptions& options) {
    CLI::Option* bound = command.add_option_function<std::string>(
        "--max-error", [&options](const std::string& text) { options.maxError = pixels(text); },
        "N or Npx: choose slices, stacks, samples and noise sizes that the scene leaves open so that nothing "
        "is drawn more than N pixels from its place");
    command
        .add_flag("--override-counts", options.overrideCounts,
                  "with --max-error: choose also what the scene states, tessellation levels among it")
        ->needs(bound);
}

}  // namespace glibra::cli
