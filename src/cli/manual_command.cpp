// `glibra manual`: the manual pages, in the macros of man(7).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "image/file.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// Text of a page: a backslash, a dash and a dot or quote at the start of a line mean something to troff.
std::string escaped(std::string_view text) {
    std::string to;
    bool isStart = true;
    for (const char each : text) {
        if (isStart && (each == '.' || each == '\'')) to += "\\&";
        if (each == '\\')
            to += "\\e";
        else if (each == '-')
            to += "\\-";
        else
            to += each;
        isStart = each == '\n';
    }
    return to;
}

std::string capitals(std::string text) {
    for (char& each : text)
        if (each >= 'a' && each <= 'z') each = static_cast<char>(each - 'a' + 'A');
    return text;
}

constexpr std::array<std::pair<int, std::string_view>, 5> kStatuses{{
    {kDone, "done"},
    {kDiffers, "a comparison or a check of a scene failed"},
    {kWrongUsage, "wrong usage"},
    {kSceneIsWrong, "a scene is wrong: language, shader, file or time-out"},
    {kNoDriver, "no usable driver"},
}};

std::string optionsOf(const CommandDescription& command, bool positional) {
    std::string text;
    for (const OptionDescription& option : command.options) {
        if (option.isPositional != positional) continue;
        std::string name;
        for (const std::string& each : {option.shortName, option.longName})
            if (!each.empty()) name += (name.empty() ? "\\fB" : "\\fR, \\fB") + escaped(each);
        if (!positional && !option.placeholder.empty()) name += "\\fR \\fI" + escaped(option.placeholder);
        text += fmt::format(".TP\n{}\\fR\n{}\n", name, escaped(option.help));
    }
    return text;
}

std::string head(const std::string& name, const std::string& summary) {
    return fmt::format(".TH \"{0}\" \"1\" \"\" \"glibra {1}\" \"glibra\"\n.SH NAME\n{2} \\- {3}\n",
                       capitals(name), GLIBRA_VERSION, escaped(name), escaped(summary));
}

std::string examplesOf(const CommandDescription& command) {
    std::string text;
    for (const std::string& each : command.examples) text += escaped(each) + "\n";
    return text.empty() ? text : ".SH EXAMPLES\n.nf\n" + text + ".fi\n";
}

std::string statuses() {
    std::string text = ".SH EXIT STATUS\n";
    for (const auto& [status, meaning] : kStatuses)
        text += fmt::format(".TP\n{}\n{}\n", status, escaped(meaning));
    return text;
}

/// The page of the program: its subcommands.
std::string programPage(const std::vector<CommandDescription>& commands) {
    const CommandDescription& program = commands.front();
    std::string text = head("glibra", program.summary);
    text +=
        ".SH SYNOPSIS\n\\fBglibra\\fR \\fISCENE\\fR\\&.glib\n.br\n\\fBglibra\\fR \\fICOMMAND\\fR "
        "[\\fIOPTIONS\\fR]\n";
    text += ".SH COMMANDS\n";
    for (const CommandDescription& each : commands)
        if (&each != &program)
            text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(each.name), escaped(each.summary));
    text += ".SH OPTIONS\n" + optionsOf(program, false) + examplesOf(program) + statuses();
    text +=
        ".SH ENVIRONMENT\n.TP\n\\fBGLIBRA_PATH\\fR\nfolders, separated by colons, that are searched for "
        "files besides the "
        "scene's own\n";
    text += ".SH SEE ALSO\n";
    for (const CommandDescription& each : commands)
        if (&each != &program && !each.options.empty())
            text += fmt::format("{}\\fBglibra\\-{}\\fR(1)", text.ends_with("ALSO\n") ? "" : ",\n",
                                escaped(each.name));
    return text + "\n";
}

std::string commandPage(const CommandDescription& command) {
    std::string text = head("glibra-" + command.name, command.summary);
    text += fmt::format(".SH SYNOPSIS\n\\fBglibra {}\\fR [\\fIOPTIONS\\fR]", escaped(command.name));
    for (const OptionDescription& each : command.options)
        if (each.isPositional) text += fmt::format(" \\fI{}\\fR", escaped(each.longName));
    text += "\n";
    if (const std::string arguments = optionsOf(command, true); !arguments.empty())
        text += ".SH ARGUMENTS\n" + arguments;
    text += ".SH OPTIONS\n" + optionsOf(command, false);
    if (command.isProgram)
        text += fmt::format("\\fBglibra {} \\-\\-help\\fR lists them.\n", escaped(command.name));
    return text + examplesOf(command) + statuses() + ".SH SEE ALSO\n\\fBglibra\\fR(1)\n";
}

int writePages(const std::vector<CommandDescription>& commands, const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    for (const CommandDescription& each : commands) {
        const bool isWhole = &each == &commands.front();
        const fs::path file = folder / (isWhole ? "glibra.1" : "glibra-" + each.name + ".1");
        const std::string page = isWhole ? programPage(commands) : commandPage(each);
        if (printErrors(image::writeFileAtomically(file, std::as_bytes(std::span(page)))))
            return kSceneIsWrong;
    }
    return kDone;
}

}  // namespace

void addManual(CommandLine& line, const Program& whole, int& status) {
    CommandLine command = line.subcommand("manual", "prints a manual page",
                                          "glibra manual | man -l -             # of the program\n"
                                          "glibra manual render | man -l -      # of a subcommand");
    const auto name = std::make_shared<std::string>();
    const auto folder = std::make_shared<fs::path>();
    command.option("command", *name, "the subcommand; without one, the program");
    command
        .option("--all", *folder,
                "writes the pages of all commands into this folder: glibra.1, glibra-render.1, ...")
        .placeholder("FOLDER")
        .written();
    command.onRun([name, folder, &whole, &status] {
        const std::vector<CommandDescription> commands = whole.describe();
        if (!folder->empty()) {
            status = writePages(commands, *folder);
            return;
        }
        std::string page;
        if (name->empty()) page = programPage(commands);
        std::vector<std::string_view> names;
        for (const CommandDescription& each : commands) {
            if (&each == &commands.front()) continue;
            names.push_back(each.name);
            if (each.name == *name) page = commandPage(each);
        }
        if (page.empty()) {
            status = refuse(fmt::format("there is no command '{}'{}", *name, base::suggestion(*name, names)));
            return;
        }
        std::fwrite(page.data(), 1, page.size(), stdout);
        status = kDone;
    });
}

}  // namespace glibra::cli
