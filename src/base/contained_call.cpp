#include "base/contained_call.h"

#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace glibra::base {
namespace {

[[noreturn]] void serveCall(const CallLimits& limits, const std::function<void()>& work) {
#ifdef __linux__
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(each, SIG_DFL);
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
    if (limits.seconds > 0) {
        // In case that nobody is left who watches the time.
        const auto seconds = static_cast<rlim_t>(std::min(std::ceil(limits.seconds) + 1, 1e9));
        const rlimit processor{seconds, seconds};
        ::setrlimit(RLIMIT_CPU, &processor);
    }
    rlimit before{};
    const bool known = ::getrlimit(RLIMIT_DATA, &before) == 0;
    MemoryLimit().set(limits.memory);
    rlimit after{};
    if (known && ::getrlimit(RLIMIT_DATA, &after) == 0 && before.rlim_cur < after.rlim_cur)
        ::setrlimit(RLIMIT_DATA, &before);  // a worker's own limit is the lower one
    work();
    ::_exit(0);
}

/// A descriptor that can be polled for the end of a process; -1 if the system has none.
int descriptorOf([[maybe_unused]] pid_t process) {
#ifdef SYS_pidfd_open
    return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
#else
    return -1;
#endif
}

/// Waits until the process has ended or the time is over. False if it still runs.
bool waitFor(pid_t process, double seconds, int& status) {
    const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    const int descriptor = descriptorOf(process);
    constexpr double kLongestWait = 3600, kBetweenQuestions = .002;
    bool ended = false;
    for (;;) {
        // Any failure means that there is nothing to wait for: the calling program ignores SIGCHLD.
        if (const pid_t got = ::waitpid(process, &status, WNOHANG); got != 0 && (got > 0 || errno != EINTR)) {
            ended = true;
            break;
        }
        const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const double left = seconds > 0 ? seconds - passed : kLongestWait;
        if (left <= 0) break;
        const double wait = std::min(left, descriptor < 0 ? kBetweenQuestions : kLongestWait);
        pollfd file{descriptor, POLLIN, 0};
        ::poll(&file, descriptor < 0 ? 0 : 1, static_cast<int>(std::ceil(wait * 1000)));
    }
    if (descriptor >= 0) ::close(descriptor);
    return ended;
}

}  // namespace

CallEnd runContained(const CallLimits& limits, const std::function<void()>& work) {
    const pid_t process = ::fork();
    if (process < 0) return {CallEnd::Kind::notStarted, 0};
    if (process == 0) serveCall(limits, work);
    int status = 0;
    if (!waitFor(process, limits.seconds, status)) {
        ::kill(process, SIGKILL);
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        return {CallEnd::Kind::timedOut, 0};
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return {CallEnd::Kind::timedOut, 0};
    if (WIFSIGNALED(status)) return {CallEnd::Kind::died, WTERMSIG(status)};
    return {WEXITSTATUS(status) == 0 ? CallEnd::Kind::finished : CallEnd::Kind::died, 0};
}

bool runInThread(const CallLimits& limits, std::function<void()> work) {
    struct State {
        std::mutex mutex;
        std::condition_variable changed;
        bool ended = false;
    };
    const auto state = std::make_shared<State>();
    std::thread([state, work = std::move(work)] {
        work();
        const std::lock_guard lock(state->mutex);
        state->ended = true;
        state->changed.notify_all();
    }).detach();
    std::unique_lock lock(state->mutex);
    const auto ended = [&] { return state->ended; };
    if (limits.seconds <= 0) {
        state->changed.wait(lock, ended);
        return true;
    }
    return state->changed.wait_for(lock, std::chrono::duration<double>(limits.seconds), ended);
}

SharedMemory::SharedMemory(std::size_t size) {
    // Without a reservation: most callers fill a small part of what they ask for.
    const auto mapped = [&](int kind) {
        return ::mmap(nullptr, size, PROT_READ | PROT_WRITE, kind | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    };
    void* memory = mapped(MAP_SHARED);
    // A confined process (sandbox.h) can neither share memory nor fork: its calls run in a thread.
    if (memory == MAP_FAILED && errno == EPERM) memory = mapped(MAP_PRIVATE);
    if (memory != MAP_FAILED) bytes_ = {static_cast<std::byte*>(memory), size};
}

SharedMemory::~SharedMemory() {
    if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
}

}  // namespace glibra::base
