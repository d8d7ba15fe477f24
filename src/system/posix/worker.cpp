#include "system/worker.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <utility>
#include <vector>

#include "system/posix/extras.h"

namespace glibra::system {

bool workersAreCopies() {
    return true;
}

std::optional<WorkerEnds> endsOfThisWorker() {
    return std::nullopt;
}

void becomeWorker() {
    endWithParent();
    beFirstToEnd();
    for (const int each : {SIGINT, SIGHUP, SIGQUIT}) ::signal(each, SIG_IGN);
    ::signal(SIGTERM, SIG_DFL);
}

void endWorker(int status) {
    if (status == 0) std::fflush(nullptr);
    ::_exit(status);
}

std::optional<Worker> startWorker(std::span<Worker* const> others, std::uint64_t memory,
                                  std::uint64_t /*call*/, const Serve& serve) {
    WorkerEnds ends{.memory = memory};
    Worker worker;
    if (makePipe(ends.requests, worker.requests) != 0) return std::nullopt;
    if (makePipe(worker.answers, ends.answers) != 0) return std::nullopt;
    std::fflush(nullptr);
    const pid_t process = ::fork();
    if (process == 0) {
        for (Worker* other : others) {
            other->requests.close();
            other->answers.close();
        }
        worker.requests.close();
        worker.answers.close();
        serve(ends);
        endWorker(1);
    }
    if (process < 0) return std::nullopt;
    worker.process = Process(process);
    return worker;
}

bool waitForAny(std::span<Worker* const> workers, int milliseconds, std::span<bool> ready) {
    std::vector<pollfd> files;
    files.reserve(workers.size());
    for (const Worker* each : workers) files.push_back({numberOf(each->answers), POLLIN, 0});
    if (::poll(files.data(), files.size(), milliseconds) < 0) return false;
    std::ranges::transform(files, ready.begin(), [](const pollfd& each) { return each.revents != 0; });
    return true;
}

Received receive(const Worker& worker, std::string& to) {
    constexpr std::size_t kPortion = 1U << 16U;
    const std::size_t had = to.size();
    to.resize(had + kPortion);
    const ssize_t got = ::read(numberOf(worker.answers), to.data() + had, kPortion);
    const int problem = errno;
    to.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got < 0 && problem == EINTR) return Received::interrupted;
    return got <= 0 ? Received::ended : Received::some;
}

struct BrokenPipesAreErrors::State {
    struct sigaction before{};
};

BrokenPipesAreErrors::BrokenPipesAreErrors() : before_(std::make_unique<State>()) {
    struct sigaction ignore{};
    ignore.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &ignore, &before_->before);
}

BrokenPipesAreErrors::~BrokenPipesAreErrors() {
    ::sigaction(SIGPIPE, &before_->before, nullptr);
}

}  // namespace glibra::system
