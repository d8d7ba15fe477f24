// How a file takes the place of another one, and how files are removed. Windows refuses both for files that
// some program has open, unless a newer kind of request is known to the file system.

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "system/windows/win.h"

#include <winternl.h>

namespace glibra::system {
namespace {

/// FILE_RENAME_INFORMATION with room for the longest name.
struct RenameRequest {
    ULONG flags = 0;
    HANDLE folder = nullptr;
    ULONG nameBytes = 0;
    std::array<wchar_t, 256> name{};
};

// Kinds of information (ntifs.h), and flags of the second one.
constexpr int kRename = 10, kRenameEx = 65;
constexpr ULONG kReplace = 1, kAlsoOpen = 2, kAlsoReadOnly = 0x40;

DWORD request(HANDLE file, HANDLE folder, const std::wstring& name, int kind, ULONG flags) {
    RenameRequest wanted;
    if (name.size() >= wanted.name.size()) return ERROR_FILENAME_EXCED_RANGE;
    wanted.flags = flags;
    wanted.folder = folder;
    wanted.nameBytes = static_cast<ULONG>(name.size() * sizeof(wchar_t));
    std::ranges::copy(name, wanted.name.begin());
    IO_STATUS_BLOCK status{};
    const NTSTATUS result = ::NtSetInformationFile(file, &status, &wanted, sizeof wanted,
                                                   static_cast<FILE_INFORMATION_CLASS>(kind));
    return result >= 0 ? DWORD{ERROR_SUCCESS} : ::RtlNtStatusToDosError(result);
}

DWORD rename(HANDLE file, HANDLE folder, const std::wstring& name) {
    const DWORD error = request(file, folder, name, kRenameEx, kReplace | kAlsoOpen | kAlsoReadOnly);
    const bool isKnown = error != ERROR_INVALID_PARAMETER && error != ERROR_NOT_SUPPORTED &&
                         error != ERROR_INVALID_FUNCTION && error != ERROR_CALL_NOT_IMPLEMENTED;
    return isKnown ? error : request(file, folder, name, kRename, kReplace);
}

/// True for errors that pass when others close the file, such as virus scanners and viewers.
bool mayPass(DWORD error) {
    return error == ERROR_ACCESS_DENIED || error == ERROR_SHARING_VIOLATION ||
           error == ERROR_LOCK_VIOLATION || error == ERROR_USER_MAPPED_FILE;
}

constexpr DWORD kOpen = 1, kLinkItself = 0x200000;

/// An error number for a name that no file can take.
int whyNot(HANDLE folder, const std::wstring& name) {
    FileFacts facts;
    const File there = openIn(folder, name, FILE_READ_ATTRIBUTES, kOpen, kLinkItself);
    if (!there) return errno == EINVAL ? EINVAL : 0;
    return factsOf(there, facts) == 0 && facts.kind == FileKind::folder ? EISDIR : 0;
}

/// Gives the old file another name first, which works while it is open.
DWORD renameAside(HANDLE file, HANDLE folder, const std::wstring& name) {
    const File old =
        openIn(folder, name, DELETE | FILE_READ_ATTRIBUTES | FILE_WRITE_ATTRIBUTES, kOpen, kLinkItself);
    if (!old) return ::GetLastError();
    DWORD error = ERROR_ALREADY_EXISTS;
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts && error == ERROR_ALREADY_EXISTS; ++attempt) {
        const std::wstring aside =
            L".glibra-" + std::to_wstring(ownNumber()) + L"-" + std::to_wstring(attempt) + L".tmp";
        error = request(winOf(old), folder, aside, kRename, 0);
    }
    if (error != ERROR_SUCCESS) return error;
    error = request(file, folder, name, kRename, 0);
    if (error != ERROR_SUCCESS)
        request(winOf(old), folder, name, kRename, 0);
    else
        removeOpen(winOf(old));  // or it is one of the abandoned files, which are removed later
    return error;
}

}  // namespace

int putInPlace(HANDLE file, HANDLE folder, const std::wstring& name) {
    constexpr DWORD kLongest = 1000, kLongestPause = 64;
    if (const int problem = whyNot(folder, name); problem != 0) return problem;
    DWORD error = rename(file, folder, name);
    for (DWORD pause = 1, passed = 0; mayPass(error) && passed < kLongest; passed += pause) {
        pause = std::min(2 * pause, kLongestPause);
        ::Sleep(pause);
        error = rename(file, folder, name);
    }
    if (mayPass(error)) error = renameAside(file, folder, name);
    return errnoOf(error);
}

int removeOpen(HANDLE file) {
    constexpr auto kDispositionEx = static_cast<FILE_INFO_BY_HANDLE_CLASS>(21);
    constexpr DWORD kRemove = 1;
    DWORD flags = kRemove | 2U | 0x10U;  // its name goes at once, also from a file that is only for reading
    if (::SetFileInformationByHandle(file, kDispositionEx, &flags, sizeof flags)) return 0;
    FILE_BASIC_INFO facts{};
    if (::GetFileInformationByHandleEx(file, FileBasicInfo, &facts, sizeof facts) &&
        (facts.FileAttributes & FILE_ATTRIBUTE_READONLY) != 0) {
        facts.FileAttributes = FILE_ATTRIBUTE_NORMAL;
        // The handle may not have that right.
        const File writable =
            ownOf(::ReOpenFile(file, FILE_WRITE_ATTRIBUTES, kShareAll, FILE_FLAG_OPEN_REPARSE_POINT));
        if (writable) ::SetFileInformationByHandle(winOf(writable), FileBasicInfo, &facts, sizeof facts);
    }
    FILE_DISPOSITION_INFO simple{TRUE};
    return ::SetFileInformationByHandle(file, FileDispositionInfo, &simple, sizeof simple) ? 0 : lastErrno();
}

}  // namespace glibra::system
