#include "view/edit/external_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <vector>

#include "view/edit/detached_process.h"

namespace glibra::view {
namespace {

/// Editors that need a terminal.
constexpr std::array<std::string_view, 10> kTerminalEditors{"vi", "vim", "nvim", "nano", "micro",
                                                            "ne", "joe", "hx",   "kak",  "emacs-nox"};

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> result;
    for (std::string word; stream >> word;) result.push_back(word);
    return result;
}

/// Adds the file and the line in the form that the editor expects.
void addPlace(std::vector<std::string>& command, const Place& place) {
    const std::string editor = std::filesystem::path(command.front()).filename().string();
    if (editor == "code" || editor == "codium") {
        command.insert(command.end(),
                       {"--goto", fmt::format("{}:{}:{}", place.file, place.line, place.column)});
    } else if (editor == "subl" || editor == "hx" || editor == "zed") {
        command.push_back(fmt::format("{}:{}:{}", place.file, place.line, place.column));
    } else if (editor == "kate" || editor == "kwrite") {
        command.insert(command.end(), {"--line", std::to_string(place.line), place.file});
    } else {
        command.insert(command.end(), {fmt::format("+{}", place.line), place.file});
    }
}

}  // namespace

std::string openInEditor(const Place& place) {
    const char* variable = std::getenv("VISUAL");
    if (!variable || !*variable) variable = std::getenv("EDITOR");
    std::vector<std::string> command = words(variable ? variable : "");
    if (command.empty())
        return "no editor is set: set the environment variable EDITOR, for example EDITOR=gedit";
    const std::string editor = std::filesystem::path(command.front()).filename().string();
    if (std::find(kTerminalEditors.begin(), kTerminalEditors.end(), editor) != kTerminalEditors.end())
        command.insert(command.begin(), {"x-terminal-emulator", "-e"});
    std::vector<std::string> full = command;
    const bool inTerminal = full.front() == "x-terminal-emulator";
    if (inTerminal) {
        std::vector<std::string> inner(full.begin() + 2, full.end());
        addPlace(inner, place);
        full.resize(2);
        full.insert(full.end(), inner.begin(), inner.end());
    } else {
        addPlace(full, place);
    }
    const std::string failure = startDetached(full);
    if (!failure.empty()) return fmt::format("cannot start '{}': {}", full.front(), failure);
    return fmt::format("opened {}:{} with {}", place.file, place.line, editor);
}

}  // namespace glibra::view
