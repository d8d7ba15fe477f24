#include "bench/core/apart.h"

#include <fmt/format.h>
#include <link.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/descriptor.h"

namespace glibra::bench {
namespace {

/// Precedes each text. Functions have the same addresses in a forked process.
struct Head {
    Apart::Work work = nullptr;  ///< requests only; null ends the process
    bool isAnswered = false;     ///< answers only; otherwise the text says why there is none
    std::size_t size = 0;
};

bool send(int file, Head head, const std::string& text) {
    head.size = text.size();
    return base::writeAll(file, std::as_bytes(std::span(&head, 1))) == 0 && base::writeAll(file, text) == 0;
}

bool receive(int file, Head& head, std::string& text) {
    if (!base::receiveAll(file, std::as_writable_bytes(std::span(&head, 1)))) return false;
    text.resize(head.size);
    return base::receiveAll(file, std::as_writable_bytes(std::span(text)));
}

/// Runs one piece of work in a new process, so that the next one finds no driver loaded.
void answerOnce(int answers, const Head& request, const std::string& text) {
    const pid_t child = fork();
    if (child == 0) {
        try {
            send(answers, {.isAnswered = true}, request.work(text));
        } catch (const std::exception&) {
            _exit(1);
        }
        _exit(0);
    }
    int status = 0;
    if (child < 0) {
        send(answers, {}, std::string("cannot be started: ") + std::strerror(errno));
        return;
    }
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status))
        send(answers, {},
             fmt::format("ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status))));
    else if (WEXITSTATUS(status) != 0)
        send(answers, {}, fmt::format("ended with status {}", WEXITSTATUS(status)));
}

bool isDriverLoaded() {
    const auto isDriver = [](dl_phdr_info* library, std::size_t, void*) {
        const std::string_view path = library->dlpi_name;
        return path.find("libEGL") != path.npos || path.find("OSMesa") != path.npos ? 1 : 0;
    };
    return dl_iterate_phdr(isDriver, nullptr) != 0;
}

/// Returns false also if the threads cannot be counted.
bool isSingleThreaded() {
    std::error_code problem;
    const std::filesystem::directory_iterator threads("/proc/self/task", problem);
    return !problem && std::distance(begin(threads), end(threads)) == 1;
}

[[noreturn]] void serve(int requests, int answers) {
    // If the parent ends, the closed pipes end this loop.
    (void)std::signal(SIGPIPE, SIG_IGN);
    Head request;
    std::string text;
    while (receive(requests, request, text) && request.work) answerOnce(answers, request, text);
    _exit(0);
}

}  // namespace

Apart::Apart() {
    if (!isSingleThreaded() || isDriverLoaded()) return;
    std::array<int, 2> requests{}, answers{};
    if (pipe(requests.data()) != 0) return;
    if (pipe(answers.data()) != 0) {
        close(requests[0]);
        close(requests[1]);
        return;
    }
    process_ = fork();
    if (process_ == 0) {
        close(requests[1]);
        close(answers[0]);
        serve(requests[0], answers[1]);
    }
    close(requests[0]);
    close(answers[1]);
    if (process_ < 0) {
        close(requests[1]);
        close(answers[0]);
        return;
    }
    requests_ = requests[1];
    answers_ = answers[0];
}

Apart::~Apart() {
    if (process_ <= 0) return;
    // Closing the pipe is not enough: processes forked since then hold it open too.
    send(requests_, {}, {});
    close(requests_);
    close(answers_);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

std::optional<std::string> Apart::run(Work work, const std::string& request) {
    if (process_ <= 0) return std::nullopt;
    Head answer;
    std::string text;
    if (!send(requests_, {.work = work}, request) || !receive(answers_, answer, text)) {
        failure_ = "gave no answer";
        return std::nullopt;
    }
    failure_ = answer.isAnswered ? std::string() : text;
    return answer.isAnswered ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace glibra::bench
