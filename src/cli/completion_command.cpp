// `glibra completion`: what the shells bash, zsh, fish and PowerShell need to complete the command line.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "image/file.h"

namespace glibra::cli {
namespace {

using base::shellQuoted;

/// The words of a choice, with blanks between them.
std::string joinedWords(const OptionDescription& option) {
    return fmt::format("{}", fmt::join(option.words, " "));
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

bool takesValue(const OptionDescription& option) {
    return !option.placeholder.empty();
}

bool namesFolder(const OptionDescription& option) {
    return option.placeholder == "FOLDER";
}

/// "-o --output"
std::string names(const OptionDescription& option) {
    if (option.shortName.empty()) return option.longName;
    return option.longName.empty() ? option.shortName : option.shortName + " " + option.longName;
}

/// In bash an option is completed after a dash, a word of a choice after its option, everything else as a
/// file.
std::string bashCompletion(const std::vector<CommandDescription>& commands) {
    std::string cases;
    std::string values;
    std::string all;
    for (const CommandDescription& command : commands) {
        std::string options;
        for (const OptionDescription& option : command.options) {
            if (option.isPositional) continue;
            options += " " + names(option);
            std::string pattern = command.name + ":" + option.longName;
            if (!option.shortName.empty()) pattern += "|" + command.name + ":" + option.shortName;
            if (!option.words.empty())
                values += fmt::format("        {}) COMPREPLY=($(compgen -W {} -- \"$word\")); return ;;\n",
                                      pattern, shellQuoted(joinedWords(option)));
            else if (namesFolder(option))
                values +=
                    fmt::format("        {}) COMPREPLY=($(compgen -d -- \"$word\")); return ;;\n", pattern);
            else if (takesValue(option))
                values +=
                    fmt::format("        {}) COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n", pattern);
        }
        cases += fmt::format("        {}) options={} ;;\n", command.name,
                             shellQuoted(options.empty() ? options : options.substr(1)));
        if (&command != &commands.front()) all += (all.empty() ? "" : " ") + command.name;
    }
    return fmt::format(R"(# bash completion of glibra, written by `glibra completion bash`
_glibra() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command=glibra options=
    [ "$COMP_CWORD" -lt 2 ] || command=${{COMP_WORDS[1]}}
    COMPREPLY=()
    case $command:$before in
{}    esac
    case $command in
{}    esac
    case $word in
        -*) COMPREPLY=($(compgen -W "$options" -- "$word")); return ;;
    esac
    if [ "$COMP_CWORD" -eq 1 ] || [ "$command" = help ]; then
        COMPREPLY=($(compgen -W '{}' -- "$word"))
        [ "$command" != help ] || return
    fi
    COMPREPLY+=($(compgen -f -- "$word"))
}}
complete -o filenames -F _glibra glibra
)",
                       values, cases, all);
}

std::string zshCompletion(const std::vector<CommandDescription>& commands) {
    std::string list;
    std::string cases;
    for (const CommandDescription& command : commands) {
        if (&command == &commands.front()) continue;
        list += "        " + shellQuoted(forZsh(command.name) + ":" + command.summary) + "\n";
        std::string arguments;
        for (const OptionDescription& option : command.options) {
            if (option.isPositional) continue;
            std::string value;
            if (!option.words.empty())
                value = fmt::format(":{}:({})", forZsh(option.placeholder), fmt::join(option.words, " "));
            else if (takesValue(option))
                value = fmt::format(":{}:{}", forZsh(option.placeholder),
                                    namesFolder(option) ? "_files -/" : "_files");
            const std::string help = "[" + forZsh(option.help) + "]" + value;
            for (const std::string& name : {option.shortName, option.longName})
                if (!name.empty()) arguments += " \\\n                " + shellQuoted("*" + name + help);
        }
        cases += fmt::format("        {}) _arguments{} \\\n                '*:file:_files' ;;\n",
                             command.name, arguments);
    }
    return fmt::format(R"(#compdef glibra
# zsh completion of glibra, written by `glibra completion zsh`
_glibra() {{
    local -a commands
    commands=(
{}    )
    if (( CURRENT == 2 )); then
        _describe command commands
        _files
        return
    fi
    local command=$words[2]
    shift words
    (( CURRENT-- ))
    case $command in
        help) _describe command commands ;;
{}        *) _files ;;
    esac
}}
if [ "$funcstack[1]" = _glibra ]; then _glibra "$@"; else compdef _glibra glibra; fi
)",
                       list, cases);
}

std::string fishCompletion(const std::vector<CommandDescription>& commands) {
    std::string lines = "# fish completion of glibra, written by `glibra completion fish`\n";
    std::string all;
    for (const CommandDescription& command : commands) {
        if (&command == &commands.front()) continue;
        all += (all.empty() ? "" : " ") + command.name;
        lines += fmt::format("complete -c glibra -n __fish_use_subcommand -a {} -d {}\n", command.name,
                             shellQuoted(command.summary));
        for (const OptionDescription& option : command.options) {
            if (option.isPositional) continue;
            std::string line =
                fmt::format("complete -c glibra -n '__fish_seen_subcommand_from {}'", command.name);
            if (!option.shortName.empty()) line += " -s " + option.shortName.substr(1);
            if (!option.longName.empty()) line += " -l " + option.longName.substr(2);
            if (!option.words.empty())
                line += fmt::format(" -x -a {}", shellQuoted(joinedWords(option)));
            else if (namesFolder(option))
                line += " -x -a '(__fish_complete_directories)'";
            else if (takesValue(option))
                line += " -r";
            lines += line + " -d " + shellQuoted(option.help) + "\n";
        }
    }
    return lines + fmt::format("complete -c glibra -n '__fish_seen_subcommand_from help' -x -a {}\n",
                               shellQuoted(all));
}

/// A word or text of PowerShell: in quotes, inside of which quotes are doubled.
std::string powerShellQuoted(std::string_view text) {
    std::string to = "'";
    for (const char each : text) to += each == '\'' ? std::string("''") : std::string(1, each);
    return to + "'";
}

/// The rows of an array of PowerShell.
std::string powerShellRows(const std::vector<std::string>& rows, const char* indent) {
    return rows.empty() ? "" : fmt::format("{}{}\n", indent, fmt::join(rows, ",\n" + std::string(indent)));
}

/// Where nothing is offered, PowerShell offers files by itself. An offer is a word, a bar and its
/// explanation.
std::string powerShellCompletion(const std::vector<CommandDescription>& commands) {
    std::string values;
    std::string options;
    std::vector<std::string> all;
    for (const CommandDescription& command : commands) {
        std::vector<std::string> rows;
        for (const OptionDescription& option : command.options) {
            if (option.isPositional) continue;
            std::vector<std::string> words;
            for (const std::string& each : option.words) words.push_back(powerShellQuoted(each));
            for (const std::string& name : {option.shortName, option.longName}) {
                if (name.empty()) continue;
                rows.push_back(powerShellQuoted(name + "|" + option.help));
                if (takesValue(option))
                    values += fmt::format(
                        "        {} {{ {} }}\n", powerShellQuoted(command.name + " " + name),
                        words.empty() ? "return" : fmt::format("$offers = {}", fmt::join(words, ", ")));
            }
        }
        options += fmt::format("            {} {{ $offers = @(\n{}            ) }}\n",
                               powerShellQuoted(command.name), powerShellRows(rows, "                "));
        if (&command == &commands.front()) continue;
        all.push_back(powerShellQuoted(command.name + "|" + command.summary));
    }
    return fmt::format(R"(# PowerShell completion of glibra, written by `glibra completion powershell`
Register-ArgumentCompleter -Native -CommandName 'glibra', 'glibra.exe' -ScriptBlock {{
    param($word, $line, $place)
    $before = @($line.CommandElements | Where-Object {{ $_.Extent.EndOffset -lt $place }} | ForEach-Object {{ $_.Extent.Text }})
    $command = if ($before.Count -gt 1) {{ $before[1] }} else {{ 'glibra' }}
    $offers = @()
    switch -CaseSensitive ($command + ' ' + $before[-1]) {{
{}    }}
    if (-not $offers -and $word -like '-*') {{
        switch -CaseSensitive ($command) {{
{}        }}
    }} elseif (-not $offers -and ($before.Count -lt 2 -or $command -ceq 'help')) {{
        $offers = @(
{}        )
    }}
    foreach ($each in $offers) {{
        $offer, $help = $each -split '\|', 2
        if (-not $help) {{ $help = $offer }}
        if ($offer.StartsWith($word, 'Ordinal')) {{
            [System.Management.Automation.CompletionResult]::new($offer, $offer, 'ParameterValue', $help)
        }}
    }}
}}
)",
                       values, options, powerShellRows(all, "            "));
}

using Completion = std::string (*)(const std::vector<CommandDescription>&);
constexpr std::array<std::pair<std::string_view, Completion>, 4> kShells{
    {{"bash", bashCompletion},
     {"zsh", zshCompletion},
     {"fish", fishCompletion},
     {"powershell", powerShellCompletion}}};

}  // namespace

void addCompletion(CommandLine& line, const Program& whole, int& status) {
    CommandLine command =
        line.subcommand("completion", "prints what a shell needs to complete the command line",
                        "source <(glibra completion bash)\n"
                        "glibra completion zsh > ~/.zfunc/_glibra\n"
                        "glibra completion fish > ~/.config/fish/completions/glibra.fish\n"
                        "glibra completion powershell | Out-String | Invoke-Expression");
    const auto chosen = std::make_shared<Completion>(nullptr);
    command.choice("shell", *chosen, kShells, "bash, zsh, fish or powershell").required();
    const auto output = std::make_shared<std::filesystem::path>();
    command.option("-o,--output", *output, "a file in place of standard output")
        .placeholder("FILE")
        .written();
    command.onRun([chosen, output, &whole, &status] {
        const std::string text = (*chosen)(whole.describe());
        status = kDone;
        if (output->empty()) {
            std::fwrite(text.data(), 1, text.size(), stdout);
            return;
        }
        if (printErrors(image::writeFileAtomically(*output, std::as_bytes(std::span(text)))))
            status = kSceneIsWrong;
    });
}

}  // namespace glibra::cli
