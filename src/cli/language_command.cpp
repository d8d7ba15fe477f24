#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "glib/command_table.h"
#include "glib/diagnostic_catalogue.h"

namespace glibra::cli {
namespace {

struct LanguageArguments {
    std::string word;
    bool diagnostics = false;
    bool words = false;
};

/// "radius [1]", "angle", "unit": the argument as a reference shows it.
std::string shown(const glib::Argument& argument) {
    std::string text(argument.name);
    if (argument.byDefault)
        text += fmt::format(" [{:g}]", *argument.byDefault);
    else if (argument.filler)
        text += fmt::format(" ({:g})", *argument.filler);
    else if (argument.optional)
        text = "[" + text + "]";
    return text;
}

std::string reference(const glib::CommandRow& row) {
    std::string head(row.name());
    if (!row.names[1].empty()) head += fmt::format(", {}", row.names[1]);
    std::string arguments;
    for (const glib::Argument& each : row.arguments)
        arguments += (arguments.empty() ? "" : "  ") + shown(each);
    return fmt::format("{:<38} {}\n{:<38} {}\n", head, row.summary, "", arguments);
}

int run(const LanguageArguments& arguments) {
    if (arguments.diagnostics) {
        for (const glib::CatalogueRow& each : glib::diagnosticCatalogue())
            fmt::print("{:<9} {:<8} {}\n", each.id, name(each.severity()), each.example);
        return kDone;
    }
    if (arguments.words) {
        for (const glib::CommandRow& row : glib::commandTable())
            for (const std::string_view each : row.names)
                if (!each.empty()) fmt::print("{}\n", each);
        return kDone;
    }
    if (arguments.word.empty()) {
        for (const glib::CommandRow& row : glib::commandTable()) fmt::print("{}", reference(row));
        return kDone;
    }
    if (const glib::CommandRow* row = glib::findCommand(arguments.word)) {
        fmt::print("{}", reference(*row));
        return kDone;
    }
    const std::string_view near = glib::nearestCommand(arguments.word);
    fmt::print(stderr, "glibra: error: no command '{}'{}\n", arguments.word,
               near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
    return kWrongUsage;
}

}  // namespace

void addLanguage(CLI::App& app, int& status) {
    auto arguments = std::make_shared<LanguageArguments>();
    CLI::App* command = app.add_subcommand("language", "the commands of the scene language; defaults in [ ]");
    command->add_option("COMMAND", arguments->word, "only this one");
    command->add_flag("--diagnostics", arguments->diagnostics, "all messages with their ids and an example");
    command->add_flag("--words", arguments->words, "all command words, one a line, for editors");
    command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace glibra::cli
