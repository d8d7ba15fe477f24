#include "cli/picture_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <variant>
#include <vector>

#include "suite/options/option_table.h"
#include "suite/options/option_words.h"

namespace glibra::cli {
namespace {

std::string dashed(std::string_view name) {
    return "--" + std::string(name);
}

/// "samples per pixel (1 to 64)"
std::string helpOf(const suite::OptionRow& row) {
    std::string text(row.help);
    if (const std::string allowed = suite::limits(row); !allowed.empty()) text += " (" + allowed + ")";
    const std::string byDefault = suite::defaultText(row);
    if (!byDefault.empty() && !std::holds_alternative<suite::FlagValue>(row.value))
        text += "; default " + byDefault;
    return text;
}

bool mayBeRepeated(const suite::OptionRow& row) {
    return std::holds_alternative<suite::UniformsValue>(row.value) ||
           std::holds_alternative<suite::ObjectsValue>(row.value) ||
           std::holds_alternative<suite::FoldersValue>(row.value);
}

void add(CLI::App& command, const suite::OptionRow& row, suite::Shot& to) {
    const std::string name = dashed(row.name);
    const auto read = [name, &row, &to](const std::string& text) {
        if (const std::string wrong = suite::readOptionText(row, text, to); !wrong.empty())
            throw CLI::ValidationError(name, wrong);
    };
    if (std::holds_alternative<suite::FlagValue>(row.value)) {
        command.add_flag_callback(
            name, [read] { read(""); }, helpOf(row));
    } else if (mayBeRepeated(row)) {
        command
            .add_option_function<std::vector<std::string>>(
                name,
                [read](const std::vector<std::string>& all) {
                    for (const std::string& each : all) read(each);
                },
                helpOf(row))
            ->type_name(suite::placeholder(row))
            ->allow_extra_args(false);
    } else {
        command.add_option_function<std::string>(name, read, helpOf(row))->type_name(suite::placeholder(row));
    }
}

/// Call it after all options have been added.
void addNeeds(CLI::App& command, const suite::OptionRow& row) {
    if (!row.needs.empty())
        command.get_option(dashed(row.name))->needs(command.get_option(dashed(row.needs)));
}

}  // namespace

void addPictureOption(CLI::App& command, std::string_view name, suite::Shot& to) {
    add(command, *suite::findOption(name), to);
}

void addPictureOptions(CLI::App& command, suite::Shot& to) {
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty()) add(command, row, to);
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty()) addNeeds(command, row);
}

void excludePictureOptions(CLI::App& command, CLI::Option& suite) {
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty() && !row.withSuite) suite.excludes(command.get_option(dashed(row.name)));
}

}  // namespace glibra::cli
