#include "view/edit/external_editor.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

#include "system/process.h"

namespace glibra::view {
namespace {

constexpr const char* kTerminal = "x-terminal-emulator";
/// Editors that need a terminal.
constexpr std::array<std::string_view, 10> kTerminalEditors{"vi", "vim", "nvim", "nano", "micro",
                                                            "ne", "joe", "hx",   "kak",  "emacs-nox"};

/// The words of a variable, or the one program that it is the path of.
std::vector<std::string> words(const std::string& text) {
    if (const std::filesystem::path whole = text; whole.is_absolute() && system::isProgram(whole))
        return {text};
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// Without the suffix that programs have on Windows.
std::string editorName(const std::string& program) {
    const std::filesystem::path name = std::filesystem::path(program).filename();
    return (name.extension() == ".exe" ? name.stem() : name).generic_string();
}

/// Adds the file and the line in the form that the editor expects.
void addPlace(std::vector<std::string>& command, const std::string& editor, const Place& place) {
    if (editor == "code" || editor == "Code" || editor == "codium") {
        command.insert(command.end(),
                       {"--goto", fmt::format("{}:{}:{}", place.file, place.line, place.column)});
    } else if (editor == "subl" || editor == "hx" || editor == "zed") {
        command.push_back(fmt::format("{}:{}:{}", place.file, place.line, place.column));
    } else if (editor == "kate" || editor == "kwrite") {
        command.insert(command.end(), {"--line", std::to_string(place.line), place.file});
    } else if (editor == "notepad++") {
        command.insert(command.end(), {fmt::format("-n{}", place.line), place.file});
    } else if (editor == "notepad") {  // it knows no lines
        command.push_back(place.file);
    } else {
        command.insert(command.end(), {fmt::format("+{}", place.line), place.file});
    }
}

}  // namespace

std::string openInEditor(const Place& place) {
    const char* variable = std::getenv("VISUAL");
    if (!variable || !*variable) variable = std::getenv("EDITOR");
    std::vector<std::string> command = words(variable && *variable ? variable : system::usualEditor());
    if (command.empty())
        return "no editor is set: set the environment variable EDITOR, for example EDITOR=gedit";
    const std::string editor = editorName(command.front());
    if (std::ranges::find(kTerminalEditors, editor) != kTerminalEditors.end())
        command.insert(command.begin(), {kTerminal, "-e"});
    const bool isInTerminal = command.front() == kTerminal && command.size() > 2;
    addPlace(command, isInTerminal ? editorName(command[2]) : editor, place);
    const std::string failure = system::startDetached(command);
    if (!failure.empty()) return fmt::format("cannot start '{}': {}", command.front(), failure);
    return fmt::format("opened {}:{} with {}", place.file, place.line, editor);
}

}  // namespace glibra::view
