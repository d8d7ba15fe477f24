// Workers are this program, started again with its arguments. It gets in GLIBRA_WORKER the number of the call
// of runInWorkers in which it is to serve, the memory that it may take, four handles, and the number of its
// parent.

#include "system/worker.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "system/memory.h"
#include "system/places.h"
#include "system/windows/win.h"

#include <fcntl.h>
#include <io.h>

namespace glibra::system {
namespace {

/// What a process that was started as a worker has got from its parent.
struct Order {
    std::uint64_t call = 0, memory = 0;
    File requests{}, answers{}, errors{}, output{};
    int parent = 0;
    bool isOnTheWay = false;
};

Order& order() {
    static Order own = [] {
        constexpr std::size_t kCount = 7;
        const std::vector<std::uint64_t> numbers = inherited(kWorkerVariable);
        if (numbers.size() != kCount) return Order();
        return Order{numbers[0],
                     numbers[1],
                     takeHandle(numbers[3]),
                     takeHandle(numbers[4]),
                     takeHandle(numbers[5]),
                     takeHandle(numbers[6]),
                     static_cast<int>(numbers[2]),
                     true};
    }();
    return own;
}

/// From now on a stream leads where that of the parent leads.
void reopen(std::FILE* stream, DWORD which, const File& to) {
    HANDLE copy = nullptr;  // which belongs to the C runtime then
    const HANDLE self = ::GetCurrentProcess();
    if (!to || !::DuplicateHandle(self, winOf(to), self, &copy, 0, FALSE, DUPLICATE_SAME_ACCESS)) return;
    const int number = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(copy), _O_BINARY);
    if (number < 0) return;
    std::fflush(stream);
    ::_dup2(number, ::_fileno(stream));
    ::_close(number);
    ::SetStdHandle(which, reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream))));
}

BOOL WINAPI leaveToParent(DWORD event) {
    return event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
}

}  // namespace

bool repeatsParent() {
    return order().isOnTheWay;
}

int parentNumber() {
    return order().parent;
}

bool workersAreCopies() {
    return false;
}

std::optional<WorkerEnds> endsOfThisWorker() {
    Order& own = order();
    if (!own.requests || !own.answers) return std::nullopt;
    return WorkerEnds{std::move(own.requests), std::move(own.answers), own.memory, own.call};
}

/// Its end with its parent is the matter of a job (start.cpp). Windows ends no process for want of memory.
void becomeWorker() {
    Order& own = order();
    own.isOnTheWay = false;
    reopen(stderr, STD_ERROR_HANDLE, own.errors);
    reopen(stdout, STD_OUTPUT_HANDLE, own.output);
    leaveNoCore();
    ::SetConsoleCtrlHandler(leaveToParent, TRUE);
}

void endWorker(int status) {
    if (status == 0) std::fflush(nullptr);
    // Not by ExitProcess(), in which drivers may wait for threads that are gone.
    ::TerminateProcess(::GetCurrentProcess(), static_cast<UINT>(status));
    std::abort();
}

std::optional<Worker> startWorker(std::span<Worker* const>, std::uint64_t memory, std::uint64_t call,
                                  const Serve&) {
    Worker worker;
    File requests, answers;
    if (makePipeEnds(PipeEnd::writes, worker.requests, requests) != 0 ||
        makePipeEnds(PipeEnd::reads, worker.answers, answers) != 0)
        return std::nullopt;
    const File nothing = openExisting(L"NUL", GENERIC_WRITE, 0);
    const auto ownOr = [&](DWORD which) {
        const HANDLE own = standardHandle(which);
        return own == nullptr ? winOf(nothing) : own;
    };
    std::fflush(nullptr);
    worker.process = start(
        {.program = programFile(),
         .words = ownWords(),
         .streams = {Stream::To::nothing, Stream::To::nothing, Stream::To::nothing},
         .handles = {winOf(requests), winOf(answers), ownOr(STD_ERROR_HANDLE), ownOr(STD_OUTPUT_HANDLE)},
         .variable = kWorkerVariable + (L'=' + std::to_wstring(call)) + L':' + std::to_wstring(memory) +
                     L':' + std::to_wstring(ownNumber())});
    if (!worker.process) return std::nullopt;
    return worker;
}

bool waitForAny(std::span<Worker* const> workers, int milliseconds, std::span<bool> ready) {
    std::vector<HANDLE> pipes;
    pipes.reserve(workers.size());
    for (const Worker* each : workers) pipes.push_back(winOf(each->answers));
    waitForBytes(pipes, ready, nullptr, waitOf(milliseconds));
    return true;
}

Received receive(const Worker& worker, std::string& to) {
    constexpr std::size_t kPortion = 1U << 16U;
    const std::size_t had = to.size();
    to.resize(had + kPortion);
    std::size_t got = 0;
    readOnce(winOf(worker.answers), to.data() + had, kPortion, got);
    to.resize(had + got);
    return got == 0 ? Received::ended : Received::some;
}

// Windows has no signal for such pipes.

struct BrokenPipesAreErrors::State {};

BrokenPipesAreErrors::BrokenPipesAreErrors() = default;

BrokenPipesAreErrors::~BrokenPipesAreErrors() = default;

}  // namespace glibra::system
