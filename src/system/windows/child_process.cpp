#include "system/child_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <utility>

#include "system/memory.h"
#include "system/places.h"
#include "system/windows/win.h"

#include <fcntl.h>
#include <io.h>

namespace glibra::system {

// A Waker is an event that stays signalled until wait() has seen it.

Waker::Waker() : reading_(ownOf(::CreateEventW(nullptr, TRUE, FALSE, nullptr))) {}

bool Waker::wake() const {
    return ::SetEvent(winOf(reading_)) != 0;
}

void Waker::wait() const {
    ::WaitForSingleObject(winOf(reading_), INFINITE);
    ::ResetEvent(winOf(reading_));
}

News receive(const File& from, int milliseconds, const Waker* waker, std::string& received) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(std::max(milliseconds, 0));
    const HANDLE woken = waker == nullptr ? nullptr : winOf(waker->file());
    const std::array<HANDLE, 1> pipes{winOf(from)};
    std::array<bool, 1> ready{};
    DWORD left = waitOf(milliseconds);
    while (!ready[0]) {
        waitForBytes(pipes, ready, woken, left);
        if (woken != nullptr && ::WaitForSingleObject(woken, 0) == WAIT_OBJECT_0) return News::woken;
        if (ready[0] || milliseconds < 0) continue;
        const auto rest = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
        if (rest <= 0) return News::late;
        left = static_cast<DWORD>(rest);
    }
    std::array<char, 1 << 12> bytes;
    std::size_t count = 0;
    readOnce(winOf(from), bytes.data(), bytes.size(), count);
    if (count == 0) return News::ended;
    received.append(bytes.data(), count);
    return News::bytes;
}

// A SharedFile is a range of addresses in which memory is asked for as its size grows, since a range of
// memory itself cannot grow.

/// Three times the largest picture.
static constexpr std::uint64_t kRange = std::uint64_t{1} << 32U;

bool SharedFile::make() {
    file_ = ownOf(::CreateFileMappingW(INVALID_HANDLE_VALUE, nullptr, PAGE_READWRITE | SEC_RESERVE,
                                       static_cast<DWORD>(kRange >> 32U), 0, nullptr));
    return static_cast<bool>(file_);
}

bool SharedFile::resize(std::size_t size) {
    if (!map(size)) return false;
    if (::VirtualAlloc(bytes_.data(), size, MEM_COMMIT, PAGE_READWRITE) != nullptr) return true;
    unmap();
    return false;
}

bool SharedFile::map(std::size_t size) {
    unmap();
    if (size > kRange) return false;
    void* const memory = ::MapViewOfFile(winOf(file_), FILE_MAP_READ | FILE_MAP_WRITE, 0, 0, size);
    if (memory != nullptr) bytes_ = {static_cast<std::byte*>(memory), size};
    return memory != nullptr;
}

void SharedFile::unmap() {
    if (!bytes_.empty()) ::UnmapViewOfFile(bytes_.data());
    bytes_ = {};
}

std::optional<ChildProcess> startChild(const std::vector<std::string>& words) {
    ChildProcess child;
    File theirs;
    if (!child.memory.make() || makePipeEnds(PipeEnd::both, child.channel, theirs) != 0) return std::nullopt;
    child.process = start({.program = programFile(),
                           .words = words,
                           .streams = {.error = Stream::To::nothing},
                           .handles = {winOf(theirs), winOf(child.memory.file())},
                           .variable = kChildVariable + std::wstring(L"=0")});
    if (!child.process) return std::nullopt;
    return child;
}

ParentEnds endsOfThisChild() {
    constexpr std::size_t kCount = 3;  // the first one is 0
    leaveNoCore();
    const std::vector<std::uint64_t> numbers = inherited(kChildVariable);
    if (numbers.size() != kCount) return {};
    return {takeHandle(numbers[1]), SharedFile(takeHandle(numbers[2]))};
}

// Pipes. Windows can wait only for those that have a name, so each gets one that nobody can guess, and all
// ends are open before anybody could know it.

namespace {

std::wstring newName() {
    static constexpr wchar_t kDigits[] = L"0123456789abcdef";
    std::array<std::byte, 16> random{};
    if (!fillWithRandom(random)) return {};
    std::wstring name = LR"(\\.\pipe\glibra-)";
    for (const std::byte each : random) {
        name += kDigits[std::to_integer<unsigned>(each) >> 4U];
        name += kDigits[std::to_integer<unsigned>(each) & 15U];
    }
    return name;
}

/// True if a pipe has bytes, or its end.
bool hasNews(HANDLE pipe) {
    DWORD count = 0;
    return !::PeekNamedPipe(pipe, nullptr, 0, nullptr, &count, nullptr) || count > 0;
}

bool lookAt(std::span<const HANDLE> pipes, std::span<bool> ready) {
    bool isAny = false;
    for (std::size_t i = 0; i < pipes.size(); ++i) {
        ready[i] = hasNews(pipes[i]);
        isAny = isAny || ready[i];
    }
    return isAny;
}

}  // namespace

int makePipeEnds(PipeEnd use, File& ours, File& theirs) {
    constexpr DWORD kBuffer = 1U << 16U;
    const std::wstring name = newName();
    if (name.empty()) return EIO;
    // A program that reads or writes standard streams does not expect a handle that does not wait. Its right
    // to attributes is what such handles usually have.
    DWORD open = PIPE_ACCESS_INBOUND | FILE_FLAG_OVERLAPPED, access = GENERIC_WRITE | FILE_READ_ATTRIBUTES;
    if (use == PipeEnd::writes) {
        open = PIPE_ACCESS_OUTBOUND;
        access = GENERIC_READ | FILE_WRITE_ATTRIBUTES;
    } else if (use == PipeEnd::both) {
        open = PIPE_ACCESS_DUPLEX | FILE_FLAG_OVERLAPPED;
        access = GENERIC_READ | GENERIC_WRITE;
    }
    ours = ownOrErrno(::CreateNamedPipeW(name.c_str(), open | FILE_FLAG_FIRST_PIPE_INSTANCE,
                                         PIPE_TYPE_BYTE | PIPE_WAIT | PIPE_REJECT_REMOTE_CLIENTS, 1, kBuffer,
                                         kBuffer, 0, nullptr));
    if (!ours) return errno;
    theirs = openExisting(name, access, use == PipeEnd::both ? FILE_FLAG_OVERLAPPED : 0, 0);
    return theirs ? 0 : errno;
}

/// A read of no bytes ends when there are some, or at the end of the pipe, and takes none of them.
void waitForBytes(std::span<const HANDLE> pipes, std::span<bool> ready, HANDLE other, DWORD milliseconds) {
    if (lookAt(pipes, ready) || milliseconds == 0) return;
    // One event for all, so that there may be any number of pipes. Each new read resets it, so all reads are
    // looked at after the last one has begun.
    const File event = ownOf(::CreateEventW(nullptr, TRUE, FALSE, nullptr));
    std::vector<OVERLAPPED> reads(pipes.size());
    std::vector<bool> isWaiting(pipes.size());
    bool isAny = false;
    char nothing = 0;
    for (std::size_t i = 0; i < pipes.size(); ++i) {
        reads[i].hEvent = winOf(event);
        isWaiting[i] =
            !::ReadFile(pipes[i], &nothing, 0, nullptr, &reads[i]) && ::GetLastError() == ERROR_IO_PENDING;
        isAny = isAny || !isWaiting[i];
    }
    for (std::size_t i = 0; i < pipes.size(); ++i)
        isAny = isAny || (isWaiting[i] && HasOverlappedIoCompleted(&reads[i]));
    const std::array<HANDLE, 2> wanted{winOf(event), other};
    if (!isAny) ::WaitForMultipleObjects(other == nullptr ? 1 : 2, wanted.data(), FALSE, milliseconds);
    for (std::size_t i = 0; i < pipes.size(); ++i) {
        if (!isWaiting[i]) continue;
        ::CancelIoEx(pipes[i], &reads[i]);
        while (!HasOverlappedIoCompleted(&reads[i])) ::WaitForSingleObject(winOf(event), 1);
    }
    lookAt(pipes, ready);
}

// Workers are this program, started again with its arguments. It gets in GLIBRA_WORKER the number of the call
// of runInWorkers in which it is to serve, the memory that it may take, four handles, and the number of its
// parent.

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

/// Its end with its parent is the matter of a job (process.cpp). Windows ends no process for want of memory.
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
