#include "suite/report/verdict_commands.h"

#include <fmt/format.h>

#include <algorithm>

#include "suite/options/option_words.h"

namespace glibra::suite {

std::string reproduceCommand(const Shot& shot) {
    std::string command = "glibra render " + shellWord(shot.script.generic_string()) + optionArguments(shot);
    if (shot.expectedError) return command;
    std::string file = shot.name;
    std::ranges::replace(file, '/', '_');
    return command + " -o " + shellWord(file + (shot.options.floatPixels ? ".exr" : ".png"));
}

std::string checkCommand(const Shot& shot) {
    const auto isUnknown = [&](const OptionRow& row) {
        return std::ranges::find(kCheckOptions, row.name) == kCheckOptions.end() &&
               !optionWords(row, shot).empty();
    };
    if (std::ranges::any_of(optionTable(), isUnknown)) return {};
    return "glibra check --run " + shellWord(shot.script.generic_string()) + optionArguments(shot);
}

std::string renameCommand(const Suite& suite, const Shot& shot) {
    return fmt::format("glibra test {} --only {} --rename", shellWord(suite.file.generic_string()),
                       shellWord(shot.name));
}

std::string acceptCommand(const Suite& suite, const Shot& shot) {
    return fmt::format("glibra test {} --only {} --update", shellWord(suite.file.generic_string()),
                       shellWord(shot.name));
}

}  // namespace glibra::suite
