#include "system/process.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

#include "system/places.h"
#include "system/posix/extras.h"

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

pid_t idOf(const Process& process) {
    return static_cast<pid_t>(process.handle());
}

End endOf(int status, const rusage& usage) {
    constexpr std::uint64_t kUnit = 1024;  // of ru_maxrss on Linux
    End end;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.wasTimeLimit = end.signal == SIGXCPU;
    end.peakMemory = static_cast<std::uint64_t>(usage.ru_maxrss) * kUnit;
    return end;
}

int modeOf(int number) {
    return number == STDIN_FILENO ? O_RDONLY : O_WRONLY;
}

}  // namespace

std::vector<char*> pointersTo(const std::vector<std::string>& words) {
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (const std::string& each : words) pointers.push_back(const_cast<char*>(each.c_str()));
    pointers.push_back(nullptr);
    return pointers;
}

Process spawn(const char* program, const std::vector<std::string>& words, const Streams& streams,
              std::initializer_list<std::pair<int, int>> descriptors) {
    const std::vector<char*> arguments = pointersTo(words);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const auto& [here, there] : descriptors) posix_spawn_file_actions_adddup2(&actions, here, there);
    int number = STDIN_FILENO;
    for (const Stream* each : {&streams.input, &streams.output, &streams.error}) {
        if (each->to == Stream::To::nothing)
            posix_spawn_file_actions_addopen(&actions, number, "/dev/null", modeOf(number), 0);
        if (each->to == Stream::To::file)
            posix_spawn_file_actions_adddup2(&actions, numberOf(*each->file), number);
        if (each->to == Stream::To::stream)
            posix_spawn_file_actions_adddup2(&actions, ::fileno(each->stream), number);
        ++number;
    }
    pid_t process = -1;
    const int failure =
        program != nullptr
            ? ::posix_spawn(&process, program, &actions, nullptr, arguments.data(), environ)
            : ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    errno = failure;
    return failure == 0 ? Process(process) : Process();
}

Process::~Process() = default;  // a number is nothing to give back

int Process::number() const {
    return static_cast<int>(handle_);
}

End waitFor(Process& process) {
    int status = 0;
    rusage usage{};
    if (process)
        while (::wait4(idOf(process), &status, 0, &usage) < 0 && errno == EINTR) {
        }
    process = Process();
    return endOf(status, usage);
}

std::optional<End> waitFor(Process& process, double seconds) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    const File descriptor(descriptorOf(idOf(process)));
    constexpr double kLongestWait = 3600, kBetweenQuestions = .002;
    int status = 0;
    rusage usage{};
    for (;;) {
        // Any failure means that there is nothing to wait for: the calling program ignores SIGCHLD.
        if (const pid_t got = ::wait4(idOf(process), &status, WNOHANG, &usage);
            got != 0 && (got > 0 || errno != EINTR)) {
            process = Process();
            return endOf(status, usage);
        }
        const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double left = seconds > 0 ? seconds - passed : kLongestWait;
        if (left <= 0) return std::nullopt;
        const double wait = std::min(left, descriptor ? kLongestWait : kBetweenQuestions);
        pollfd file{numberOf(descriptor), POLLIN, 0};
        ::poll(&file, descriptor ? 1 : 0, static_cast<int>(std::ceil(wait * 1000)));
    }
}

void kill(const Process& process) {
    if (process) ::kill(idOf(process), SIGKILL);
}

int ownNumber() {
    return ::getpid();
}

bool isRunning(long long number) {
    return number > 0 && std::in_range<pid_t>(number) &&
           (::kill(static_cast<pid_t>(number), 0) == 0 || errno != ESRCH);
}

double processorSecondsOf(const Process& process) {
    return processorSecondsOf(idOf(process));
}

Process startProgram(const std::vector<std::string>& words, const Streams& streams) {
    return spawn(nullptr, words, streams);
}

Process startAgain(const std::vector<std::string>& words, const Streams& streams) {
    return spawn(pathOfThisProgram().c_str(), words, streams);
}

namespace {

/// Runs in the child. Between fork and exec, only calls that are safe in the child of a program with threads.
[[noreturn]] void becomeDetached(char* const* arguments, int report) {
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

}  // namespace

std::string startDetached(const std::vector<std::string>& words) {
    const std::vector<char*> arguments = pointersTo(words);
    // The exec closes the pipe's end in the child. Until then the child can report why it failed.
    File reading, writing;
    if (const int problem = makePipe(reading, writing); problem != 0)
        return std::generic_category().message(problem);
    const pid_t child = ::fork();
    if (child == 0) becomeDetached(arguments.data(), numberOf(writing));
    int failure = child < 0 ? errno : 0;
    writing.close();
    if (child > 0) {
        receiveAll(reading, std::as_writable_bytes(std::span(&failure, 1)));
        Process between(child);
        waitFor(between);
    }
    return failure == 0 ? std::string() : std::generic_category().message(failure);
}

std::string openForUser(const fs::path& file) {
    return startDetached({"xdg-open", file.string()});
}

const char* usualEditor() {
    return "";
}

int becomeProgram(const fs::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ::execv(program.c_str(), pointersTo(words).data());
    return errno;
}

bool isProgram(const fs::path& file) {
    return ::access(file.c_str(), X_OK) == 0;
}

fs::path findInPath(const std::string& name) {
    for (const fs::path& each : foldersIn("PATH"))
        if (isProgram(each / name)) return each / name;
    return {};
}

int makeInputOf(File& reading, File& writing) {
    int ends[2];
    if (!openSockets(ends)) return errno;
    reading = File(ends[0]);
    writing = File(ends[1]);
    return 0;
}

int sendAll(const File& writing, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(numberOf(writing), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return sent < 0 ? errno : EPIPE;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return 0;
}

Process runInCopy(const std::function<void()>& work) {
    const pid_t process = ::fork();
    if (process == 0) {
        try {
            work();
        } catch (const std::exception&) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    return process < 0 ? Process() : Process(process);
}

void endBySignals() {
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(each, SIG_DFL);
}

void onCopy(void (*note)()) {
    ::pthread_atfork(nullptr, nullptr, note);
}

}  // namespace glibra::system
