#include "view/edit/detached_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

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

}  // namespace glibra::view
