// Pipes. Windows can wait only for those that have a name, so each gets one that nobody can guess, and all
// ends are open before anybody could know it.

#include <array>
#include <cerrno>

#include "system/places.h"
#include "system/windows/win.h"

namespace glibra::system {
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

}  // namespace glibra::system
