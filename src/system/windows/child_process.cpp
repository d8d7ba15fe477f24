#include "system/child_process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

#include "system/memory.h"
#include "system/places.h"
#include "system/windows/win.h"

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

}  // namespace glibra::system
