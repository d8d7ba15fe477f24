// `glibra manual`: the manual pages, in the macros of man(7). `glibra completion`: what the shells bash, zsh,
// fish and PowerShell need to complete the command line. The descriptions of the commands fill the templates
// in cli/pages.

#include <fmt/format.h>
#include <fmt/ranges.h>

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

#include "base/page_template.h"
#include "base/suggest.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "embedded/command_pages.h"
#include "image/file.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

using Commands = std::vector<CommandDescription>;
using Escape = std::string (*)(std::string_view);

std::string asGiven(std::string_view text) {
    return std::string(text);
}

/// `explained` is applied to help and placeholders.
base::Fields fieldsOf(const OptionDescription& option, Escape explained) {
    std::vector<std::string> forms;
    for (const std::string& each : {option.shortName, option.longName})
        if (!each.empty()) forms.push_back(each);
    return {{"eachForm", forms},
            {"short", option.shortName},
            {"letter", option.shortName.empty() ? "" : option.shortName.substr(1)},
            {"long", option.longName},
            {"name", option.longName.starts_with("--") ? option.longName.substr(2) : ""},
            {"placeholder", option.isPositional ? "" : explained(option.placeholder)},
            {"folder", option.placeholder == "FOLDER"},
            {"words", fmt::format("{}", fmt::join(option.words, " "))},
            {"eachWord", option.words},
            {"help", explained(option.help)}};
}

/// The options are also there once for each of their names, as `forms`.
base::Fields fieldsOf(const CommandDescription& command, Escape explained) {
    std::vector<base::Fields> options, arguments, forms;
    for (const OptionDescription& each : command.options) {
        const base::Fields fields = fieldsOf(each, explained);
        (each.isPositional ? arguments : options).push_back(fields);
        for (const std::string& form : {each.shortName, each.longName}) {
            if (form.empty() || each.isPositional) continue;
            forms.push_back(fields);
            forms.back().emplace_back("form", form);
        }
    }
    return {{"command", command.name}, {"summary", command.summary},
            {"arguments", arguments},  {"options", options},
            {"forms", forms},          {"isProgram", command.isProgram}};
}

/// The subcommands come after the program.
base::Fields fieldsOf(const Commands& commands, Escape explained) {
    const auto fields = [&](const CommandDescription& each) { return fieldsOf(each, explained); };
    return {{"commands", base::rowsOf(commands, fields)},
            {"subcommands", base::rowsOf(std::span(commands).subspan(1), fields)}};
}

int writeText(const fs::path& file, const std::string& text) {
    const bool failed = printErrors(image::writeFileAtomically(file, std::as_bytes(std::span(text))));
    return failed ? kSceneIsWrong : kDone;
}

int printText(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return kDone;
}

// ---- Manual pages

/// Text of a page: a backslash, a dash and a dot or quote at the start of a line mean something to troff.
std::string forTroff(std::string_view text) {
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

constexpr std::array<std::pair<int, std::string_view>, 5> kStatuses{{
    {kDone, "done"},
    {kDiffers, "a comparison or a check of a scene failed"},
    {kWrongUsage, "wrong usage"},
    {kSceneIsWrong, "a scene is wrong: language, shader, file or time-out"},
    {kNoDriver, "no usable driver"},
}};

/// "glibra", "glibra-render".
std::string pageName(const Commands& commands, const CommandDescription& command) {
    return &command == &commands.front() ? "glibra" : "glibra-" + command.name;
}

std::string manualPage(const Commands& commands, const CommandDescription& command) {
    const std::string page = pageName(commands, command);
    std::string capitals = page;
    for (char& each : capitals)
        if (each >= 'a' && each <= 'z') each = static_cast<char>(each - 'a' + 'A');
    std::vector<std::string> documented;
    for (const CommandDescription& each : std::span(commands).subspan(1))
        if (!each.options.empty()) documented.push_back(each.name);
    base::Fields fields = fieldsOf(command, asGiven);
    base::append(fields, fieldsOf(commands, asGiven));
    const auto status = [](const auto& each) {
        return base::Fields{{"status", each.first}, {"meaning", each.second}};
    };
    base::append(fields, {{"page", page},
                          {"capitals", capitals},
                          {"version", GLIBRA_VERSION},
                          {"documented", documented},
                          {"examples", fmt::format("{}", fmt::join(command.examples, "\n"))},
                          {"statuses", base::rowsOf(kStatuses, status)}});
    const char* part = page == "glibra" ? "{{>program}}" : "{{>command}}";
    return base::filled(std::string(command_pages::manual_man()) + part, fields, forTroff);
}

/// Prints the page of a command; that of the program if the name is empty.
int printPage(const Commands& commands, const std::string& name) {
    if (name.empty()) return printText(manualPage(commands, commands.front()));
    std::vector<std::string_view> names;
    for (const CommandDescription& each : std::span(commands).subspan(1)) {
        if (each.name == name) return printText(manualPage(commands, each));
        names.push_back(each.name);
    }
    return refuse(fmt::format("there is no command '{}'{}", name, base::suggestion(name, names)));
}

int writePages(const Commands& commands, const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    int status = kDone;
    for (std::size_t i = 0; i < commands.size() && status == kDone; ++i)
        status =
            writeText(folder / (pageName(commands, commands[i]) + ".1"), manualPage(commands, commands[i]));
    return status;
}

// ---- Completions

/// The text inside of single quotes of a POSIX shell.
std::string inShellQuotes(std::string_view text) {
    const std::string quoted = base::shellQuoted(text);
    return quoted.substr(1, quoted.size() - 2);
}

/// The text inside of single quotes of PowerShell.
std::string inPowerShellQuotes(std::string_view text) {
    std::string to;
    for (const char each : text) to.append(each == '\'' ? 2 : 1, each);
    return to;
}

/// A text of zsh's _arguments, which gives a meaning to colons and brackets.
std::string forZsh(std::string_view text) {
    std::string to;
    for (const char each : text) {
        if (each == ':' || each == '[' || each == ']' || each == '\\') to += '\\';
        to += each;
    }
    return to;
}

struct Shell {
    std::string_view page;
    Escape escape = inShellQuotes;
    Escape explained = asGiven;
};

constexpr std::array<std::pair<std::string_view, Shell>, 4> kShells{
    {{"bash", {command_pages::completion_bash()}},
     {"zsh", {command_pages::completion_zsh(), inShellQuotes, forZsh}},
     {"fish", {command_pages::completion_fish()}},
     {"powershell", {command_pages::completion_ps1(), inPowerShellQuotes}}}};

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
        status = folder->empty() ? printPage(whole.describe(), *name) : writePages(whole.describe(), *folder);
    });
}

void addCompletion(CommandLine& line, const Program& whole, int& status) {
    CommandLine command =
        line.subcommand("completion", "prints what a shell needs to complete the command line",
                        "source <(glibra completion bash)\n"
                        "glibra completion zsh > ~/.zfunc/_glibra\n"
                        "glibra completion fish > ~/.config/fish/completions/glibra.fish\n"
                        "glibra completion powershell | Out-String | Invoke-Expression");
    const auto chosen = std::make_shared<Shell>();
    command.choice("shell", *chosen, kShells, "bash, zsh, fish or powershell").required();
    const auto output = std::make_shared<fs::path>();
    command.option("-o,--output", *output, "a file in place of standard output")
        .placeholder("FILE")
        .written();
    command.onRun([chosen, output, &whole, &status] {
        Commands commands = whole.describe();
        for (CommandDescription& each : commands)
            for (OptionDescription& option : each.options)
                if (each.name == "manual" && option.isPositional) option.words = whole.subcommands();
        const std::string text =
            base::filled(chosen->page, fieldsOf(commands, chosen->explained), chosen->escape);
        status = output->empty() ? printText(text) : writeText(*output, text);
    });
}

}  // namespace glibra::cli
