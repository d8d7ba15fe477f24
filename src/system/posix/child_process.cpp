#include "system/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>

#include "system/memory.h"
#include "system/places.h"
#include "system/posix/extras.h"

namespace glibra::system {
namespace {

/// The descriptors of a child. They are above all that its parent has open.
constexpr int kChannel = 200, kMemory = 201;

}  // namespace

Waker::Waker() {
    int reading = -1, writing = -1;
    if (!openWaker(reading, writing)) return;
    reading_ = File(reading);
    if (writing != reading) writing_ = File(writing);
}

bool Waker::wake() const {
    const std::uint64_t one = 1;
    return ::write(numberOf(writing_ ? writing_ : reading_), &one, sizeof one) == sizeof one;
}

void Waker::wait() const {
    std::uint64_t count = 0;
    while (::read(numberOf(reading_), &count, sizeof count) < 0 && errno == EINTR) {
    }
}

News receive(const File& from, int milliseconds, const Waker* waker, std::string& received) {
    std::array<pollfd, 2> wanted{
        {{numberOf(from), POLLIN, 0}, {waker ? numberOf(waker->file()) : -1, POLLIN, 0}}};
    int ready = -1;
    do ready = ::poll(wanted.data(), wanted.size(), milliseconds);
    while (ready < 0 && errno == EINTR);
    if (wanted[1].revents != 0) return News::woken;
    if (ready == 0) return News::late;
    std::array<char, 1 << 12> bytes;
    ssize_t length = 0;
    do length = ready > 0 ? ::read(numberOf(from), bytes.data(), bytes.size()) : 0;
    while (length < 0 && errno == EINTR);
    if (length <= 0) return News::ended;
    received.append(bytes.data(), static_cast<std::size_t>(length));
    return News::bytes;
}

bool SharedFile::make() {
    file_ = File(openMemoryFile("glibra picture"));
    return static_cast<bool>(file_);
}

bool SharedFile::resize(std::size_t size) {
    unmap();
    return ::ftruncate(numberOf(file_), static_cast<off_t>(size)) == 0 && map(size);
}

bool SharedFile::map(std::size_t size) {
    unmap();
    void* const memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, numberOf(file_), 0);
    if (memory == MAP_FAILED) return false;
    bytes_ = {static_cast<std::byte*>(memory), size};
    return true;
}

void SharedFile::unmap() {
    if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
    bytes_ = {};
}

std::optional<ChildProcess> startChild(const std::vector<std::string>& words) {
    ChildProcess child;
    File theirs;
    if (!child.memory.make() || makeInputOf(child.channel, theirs) != 0) return std::nullopt;
    child.process = spawn(pathOfThisProgram().c_str(), words, {.error = Stream::To::nothing},
                          {{numberOf(theirs), kChannel}, {numberOf(child.memory.file()), kMemory}});
    if (!child.process) return std::nullopt;
    return child;
}

ParentEnds endsOfThisChild() {
    // The process belongs to the window, also while it does not read the channel.
    endWithParent();
    leaveNoCore();
    return {File(kChannel), SharedFile(File(kMemory))};
}

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
