#include "view/edit/external_editor.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace glibra::view {
namespace {

/// Runs in the child. Between fork and exec, only calls that are safe in the child of a program with threads.
[[noreturn]] void becomeProgram(char* const* arguments, int report) {
    ::setsid();
    const pid_t process = ::fork();
    if (process > 0) ::_exit(0);
    if (process == 0) {
        sigset_t none;
        sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        ::execvp(arguments[0], arguments);
    }
    const int failure = errno;
    // If this write fails too, the error cannot be reported.
    [[maybe_unused]] const ssize_t written = ::write(report, &failure, sizeof failure);
    ::_exit(127);
}

/// As exec takes them.
std::vector<char*> pointersTo(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& each : words) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    return pointers;
}

}  // namespace

std::string startDetached(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments = pointersTo(words);
    // The exec closes the pipe's end in the child. Until then the child can report why it failed.
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::generic_category().message(errno);
    const pid_t child = ::fork();
    if (child == 0) becomeProgram(arguments.data(), ends[1]);
    int failure = child < 0 ? errno : 0;
    ::close(ends[1]);
    if (child > 0) {
        while (::read(ends[0], &failure, sizeof failure) < 0 && errno == EINTR) {
        }
        while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    ::close(ends[0]);
    return failure == 0 ? std::string() : std::generic_category().message(failure);
}

pid_t startAgain(std::vector<std::string> words, std::initializer_list<std::pair<int, int>> descriptors) {
    std::vector<char*> arguments = pointersTo(words);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const auto& [here, there] : descriptors) posix_spawn_file_actions_adddup2(&actions, here, there);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    const int failure = posix_spawn(&process, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure == 0 ? process : -1;
}

namespace {

constexpr const char* kTerminal = "x-terminal-emulator";
/// Editors that need a terminal.
constexpr std::array<std::string_view, 10> kTerminalEditors{"vi", "vim", "nvim", "nano", "micro",
                                                            "ne", "joe", "hx",   "kak",  "emacs-nox"};

std::vector<std::string> words(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::string editorName(const std::string& program) {
    return std::filesystem::path(program).filename().string();
}

/// Adds the file and the line in the form that the editor expects.
void addPlace(std::vector<std::string>& command, const std::string& editor, const Place& place) {
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
    const std::string editor = editorName(command.front());
    if (std::ranges::find(kTerminalEditors, editor) != kTerminalEditors.end())
        command.insert(command.begin(), {kTerminal, "-e"});
    const bool isInTerminal = command.front() == kTerminal && command.size() > 2;
    addPlace(command, isInTerminal ? editorName(command[2]) : editor, place);
    const std::string failure = startDetached(command);
    if (!failure.empty()) return fmt::format("cannot start '{}': {}", command.front(), failure);
    return fmt::format("opened {}:{} with {}", place.file, place.line, editor);
}

}  // namespace glibra::view
