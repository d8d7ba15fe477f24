#pragma once
// What the files of this folder share. Nobody else includes it: it brings <windows.h> with its macros.

#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX 1
#endif
#undef _WIN32_WINNT
#define _WIN32_WINNT 0x0A00  // Windows 10
#include <windows.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "system/file.h"
#include "system/process.h"

namespace glibra::system {

// Words and errors: words.cpp

/// UTF-8 to UTF-16 and back. What is wrong becomes U+FFFD.
std::wstring wideOf(std::string_view text);
std::string narrowOf(std::wstring_view text);
/// The number of <cerrno> for an error of Windows.
int errnoOf(DWORD error);
int lastErrno();
/// The system's own words for an error, without a full stop.
std::string textOf(DWORD error);
/// A path as the system takes it, also if it is longer than MAX_PATH.
std::wstring pathText(const std::filesystem::path& path);
/// The value of a variable of the environment; empty if there is none.
std::wstring variableText(const wchar_t* name);

// Handles

inline constexpr DWORD kShareAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

inline HANDLE winOf(const File& file) {
    return reinterpret_cast<HANDLE>(file.handle());
}
/// Takes a handle over, which is null or INVALID_HANDLE_VALUE if there is none.
inline File ownOf(HANDLE handle) {
    return handle == nullptr ? File() : File(reinterpret_cast<Handle>(handle));
}
/// The same; without one, errno says why.
File ownOrErrno(HANDLE handle);
/// A handle of a standard stream; null if there is none.
HANDLE standardHandle(DWORD which);

/// An operation that may not be done at once.
struct Pending {
    Pending() : event(ownOf(::CreateEventW(nullptr, TRUE, FALSE, nullptr))) { state.hEvent = winOf(event); }
    File event;
    OVERLAPPED state{};
};

// Files: file.cpp

/// Opens an existing file. No other process can take our identity by being what is opened.
File openExisting(const std::filesystem::path& path, DWORD access, DWORD flags, DWORD share = kShareAll);
/// True for a symbolic link or a junction, if the handle is to the link itself.
bool isLink(HANDLE file);
/// True if both are the same file.
bool isSame(HANDLE first, HANDLE second);
/// Reads once; 0 bytes: the end. Returns an error of Windows or 0.
DWORD readOnce(HANDLE from, void* to, std::size_t most, std::size_t& count);

/// True if a file belongs to the user of this process, or to the group that owns what the user makes.
bool isOwn(HANDLE file);
/// Gives a new file the access list of an old one, as far as the old one did not inherit it from its folder.
void copyAccessList(HANDLE from, HANDLE to);

/// The access of what only this user may use.
class PrivateAccess {
  public:
    PrivateAccess();
    PrivateAccess(const PrivateAccess&) = delete;
    PrivateAccess& operator=(const PrivateAccess&) = delete;
    ~PrivateAccess();
    /// Null if the system does not tell who the user is: the usual access.
    [[nodiscard]] SECURITY_ATTRIBUTES* attributes() { return list_ == nullptr ? nullptr : &attributes_; }

  private:
    PSECURITY_DESCRIPTOR list_ = nullptr;
    SECURITY_ATTRIBUTES attributes_{};
};

// Files by their names in folders: folder.cpp

/// Opens or makes a file or folder in an open folder, by functions of the kernel, since Win32 has none for
/// that. `disposition` and `options` are those of NtCreateFile. An empty value: errno.
File openIn(HANDLE folder, const std::wstring& name, DWORD access, DWORD disposition, DWORD options,
            DWORD attributes = FILE_ATTRIBUTE_NORMAL);
/// Puts an open file in the place of a name. The handle has the right DELETE. Returns 0 or an error number.
int putInPlace(HANDLE file, HANDLE folder, const std::wstring& name);
/// Removes the name of an open file, whose handle has the right DELETE. Returns 0 or an error number.
int removeOpen(HANDLE file);

// Pipes: child_process.cpp

enum class PipeEnd { reads, writes, both };
/// A pipe. `ours` can be waited for if it reads; `theirs` is for simple reads and writes as programs make
/// them, unless it is for both directions. Returns 0 or an error number.
int makePipeEnds(PipeEnd use, File& ours, File& theirs);
/// Waits until one of the pipes has bytes or has ended, or `other` is signalled (null: nothing), at most so
/// long. It may end earlier.
void waitForBytes(std::span<const HANDLE> pipes, std::span<bool> ready, HANDLE other, DWORD milliseconds);
inline DWORD waitOf(int milliseconds) {
    return milliseconds < 0 ? INFINITE : static_cast<DWORD>(milliseconds);
}

// Processes: process.cpp

/// What the handle of a Process points to.
struct Started {
    File process;
    File job;  ///< it and all that it starts
};
inline HANDLE winOf(const Process& process) {
    return process ? winOf(reinterpret_cast<const Started*>(process.handle())->process) : nullptr;
}

/// How a process is started.
struct Start {
    std::filesystem::path program{};
    std::vector<std::string> words{};
    Streams streams{};
    /// Handles that it inherits beside its streams. Their values in it are written to the variable, which
    /// begins with `variable`, separated by colons.
    std::vector<HANDLE> handles{};
    std::wstring variable{};  ///< "NAME=value"; empty: none
};
/// An empty value: errno.
Process start(const Start& start);
/// One command line that CommandLineToArgvW takes apart into these words.
std::wstring commandLine(const std::vector<std::string>& words);

/// The exit status of a process that something like a signal has ended, which endOf() recognizes.
constexpr UINT statusOfSignal(int signal) {
    return 0xE0670000U | static_cast<UINT>(signal);
}
/// Signals that <csignal> has only on other systems.
inline constexpr int kHangup = 1, kKilled = 9, kAlarm = 14, kTimeLimit = 24;

/// What a process gets from the one that has started it, in the variable `name`, at its first call; the
/// variable is gone then, so that what it starts does not get it. Empty: nothing.
std::vector<std::uint64_t> inherited(const wchar_t* name);
/// To be called before anything is started. True if there is something for this process.
bool takeInheritance();
inline constexpr const wchar_t *kWorkerVariable = L"GLIBRA_WORKER", *kChildVariable = L"GLIBRA_CHILD";
/// Takes over a handle of an inherited list.
File takeHandle(std::uint64_t value);

/// True in a process that was started to be a worker and has not come to its call (child_process.h):
/// functions that change files report success and do nothing, since the process parentNumber() has done that.
bool repeatsParent();
int parentNumber();
/// What is written there is gone.
File nullDevice();

/// Gives the console back as it was. For whoever ends the process without exit().
void restoreConsole();

}  // namespace glibra::system
