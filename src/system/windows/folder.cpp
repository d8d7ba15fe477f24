// Files by their names in open folders. Win32 knows only paths; the kernel opens a name in an open folder, as
// openat() does elsewhere.

#include "system/folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "system/windows/win.h"

#include <winternl.h>

namespace glibra::system {

namespace {

namespace fs = std::filesystem;

// Of the kernel's interface, which <winternl.h> has in part.
constexpr DWORD kOpen = 1, kMakeNew = 2;                                                     // dispositions
constexpr DWORD kFolder = 1, kSynchronous = 0x20, kNoFolder = 0x40, kLinkItself = 0x200000;  // options

bool isPlain(std::wstring_view name) {
    if (name.empty() || name.back() == L'.' || name.back() == L' ') return false;
    const auto isForbidden = [](wchar_t each) {
        return each < L' ' || std::wstring_view(LR"(\/:*?"<>|)").find(each) != std::wstring_view::npos;
    };
    if (std::ranges::any_of(name, isForbidden)) return false;
    // Devices, with any suffix: "nul.png" may be the null device.
    std::wstring begin(name.substr(0, name.find(L'.')));
    while (!begin.empty() && begin.back() == L' ') begin.pop_back();
    ::CharUpperW(begin.data());
    static constexpr std::wstring_view kDevices[] = {L"CON", L"PRN", L"AUX", L"NUL", L"CONIN$", L"CONOUT$"};
    if (std::ranges::find(kDevices, begin) != std::end(kDevices)) return false;
    const bool isPort = begin.size() == 4 && (begin.starts_with(L"COM") || begin.starts_with(L"LPT"));
    return !isPort ||
           std::wstring_view(L"0123456789\u00b9\u00b2\u00b3").find(begin[3]) == std::wstring_view::npos;
}

/// A name in a folder that is no link, which is opened with these rights. As openUnlessLink() in file.cpp, it
/// is opened twice.
File openNamed(const File& folder, const std::string& name, DWORD access, DWORD options) {
    const std::wstring wide = wideOf(name);
    const File named = openIn(winOf(folder), wide, FILE_READ_ATTRIBUTES, kOpen, kLinkItself);
    if (!named) return {};
    if (isLink(winOf(named))) {
        errno = ELOOP;
        return {};
    }
    File file = openIn(winOf(folder), wide, access, kOpen, options);
    if (file && !isSame(winOf(named), winOf(file))) {
        errno = ELOOP;
        return {};
    }
    return file;
}

/// The attributes that users set.
constexpr DWORD kKept = FILE_ATTRIBUTE_READONLY | FILE_ATTRIBUTE_HIDDEN | FILE_ATTRIBUTE_SYSTEM;

void copyAttributes(HANDLE from, HANDLE to) {
    FILE_BASIC_INFO old{}, made{};
    if (!::GetFileInformationByHandleEx(from, FileBasicInfo, &old, sizeof old) ||
        !::GetFileInformationByHandleEx(to, FileBasicInfo, &made, sizeof made))
        return;
    made.FileAttributes = (made.FileAttributes & ~kKept) | (old.FileAttributes & kKept);
    ::SetFileInformationByHandle(to, FileBasicInfo, &made, sizeof made);
}

/// Both are no links.
void keepAccessOf(HANDLE replaced, HANDLE by) {
    if (!isOwn(replaced)) return;
    copyAccessList(replaced, by);
    copyAttributes(replaced, by);
}

constexpr DWORD kForAccess = READ_CONTROL | FILE_READ_ATTRIBUTES;
constexpr DWORD kForNewAccess = kForAccess | WRITE_DAC | FILE_WRITE_ATTRIBUTES;

/// Makes a new file beside the one that it will replace.
File makeBetween(HANDLE folder) {
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const std::wstring name =
            L".glibra-" + std::to_wstring(ownNumber()) + L"-" + std::to_wstring(attempt) + L".tmp";
        File file = openIn(folder, name, GENERIC_WRITE | DELETE | kForNewAccess, kMakeNew, kNoFolder);
        if (file || errno != EEXIST) return file;
    }
    return {};
}

}  // namespace

File openIn(HANDLE folder, const std::wstring& name, DWORD access, DWORD disposition, DWORD options,
            DWORD attributes) {
    if (!isPlain(name)) {
        errno = EINVAL;
        return {};
    }
    const auto bytes = static_cast<USHORT>(std::min<std::size_t>(name.size() * sizeof(wchar_t), 0xFFFE));
    UNICODE_STRING text{bytes, bytes, const_cast<wchar_t*>(name.c_str())};
    OBJECT_ATTRIBUTES object{};
    object.Length = sizeof object;
    object.RootDirectory = folder;
    object.ObjectName = &text;
    object.Attributes = OBJ_CASE_INSENSITIVE;
    IO_STATUS_BLOCK status{};
    HANDLE file = nullptr;
    const NTSTATUS result = ::NtCreateFile(&file, access | SYNCHRONIZE, &object, &status, nullptr, attributes,
                                           kShareAll, disposition, options | kSynchronous, nullptr, 0);
    if (result >= 0) return ownOf(file);
    ::SetLastError(::RtlNtStatusToDosError(result));
    errno = lastErrno();
    return {};
}

bool isPlainName(const std::string& name) {
    return isPlain(wideOf(name));
}

File openFolder(const fs::path& folder, FolderUse use) {
    // Names can be added and removed below a handle that only passes.
    const DWORD access = FILE_TRAVERSE | FILE_READ_ATTRIBUTES | SYNCHRONIZE |
                         (use == FolderUse::listed ? DWORD{FILE_LIST_DIRECTORY} : 0);
    File opened = openExisting(folder.empty() ? fs::path(L".") : folder, access, FILE_FLAG_BACKUP_SEMANTICS);
    FILE_BASIC_INFO found{};
    if (opened && (!::GetFileInformationByHandleEx(winOf(opened), FileBasicInfo, &found, sizeof found) ||
                   (found.FileAttributes & FILE_ATTRIBUTE_DIRECTORY) == 0)) {
        errno = ENOTDIR;
        return {};
    }
    return opened;
}

File openFolderIn(const File& folder, const std::string& name, FolderUse use) {
    const DWORD list = use == FolderUse::listed ? FILE_LIST_DIRECTORY : 0;
    return openNamed(folder, name, FILE_TRAVERSE | FILE_READ_ATTRIBUTES | list, kFolder);
}

int makeFolderIn(const File& folder, const std::string& name) {
    const File made = openIn(winOf(folder), wideOf(name), FILE_READ_ATTRIBUTES, kMakeNew, kFolder);
    return made || errno == EEXIST ? 0 : errno;
}

File openFileIn(const File& folder, const std::string& name) {
    File file = openNamed(folder, name, GENERIC_READ, 0);
    FileFacts facts;
    if (file && (factsOf(file, facts) != 0 || facts.kind != FileKind::regular)) {
        errno = ENOTSUP;
        return {};
    }
    return file;
}

int removeIn(const File& folder, const std::string& name) {
    if (repeatsParent()) return 0;
    const File file = openIn(winOf(folder), wideOf(name), DELETE | FILE_READ_ATTRIBUTES, kOpen, kLinkItself);
    if (!file) return errno;
    FileFacts facts;
    if (factsOf(file, facts) == 0 && facts.kind == FileKind::folder) return EISDIR;
    return removeOpen(winOf(file));
}

int clearNameIn(const File& folder, const std::string& name) {
    if (repeatsParent()) return 0;
    const File file = openIn(winOf(folder), wideOf(name), FILE_READ_ATTRIBUTES, kOpen, kLinkItself);
    if (!file) return errno == ENOENT ? 0 : errno;
    FileFacts facts;
    if (const int problem = factsOf(file, facts); problem != 0) return problem;
    return facts.kind == FileKind::regular ? 0 : removeIn(folder, name);
}

int replaceIn(const File& folder, const std::string& name, std::span<const std::byte> bytes) {
    if (repeatsParent()) return 0;
    const std::wstring wide = wideOf(name);
    if (!isPlain(wide)) return EINVAL;
    const File file = makeBetween(winOf(folder));
    if (!file) return errno;
    int problem = writeAll(file, bytes);
    if (const File old = openNamed(folder, name, kForAccess, kNoFolder); old)
        keepAccessOf(winOf(old), winOf(file));
    if (problem == 0) problem = sync(file);
    if (problem == 0) problem = putInPlace(winOf(file), winOf(folder), wide);
    if (problem != 0) removeOpen(winOf(file));
    return problem;
}

int renameOver(const fs::path& from, const fs::path& to) {
    if (repeatsParent()) return 0;
    const File file = openExisting(from, DELETE | FILE_READ_ATTRIBUTES | SYNCHRONIZE,
                                   FILE_FLAG_OPEN_REPARSE_POINT | FILE_FLAG_BACKUP_SEMANTICS);
    if (!file) return errno;
    const File folder = openFolder(to.parent_path(), FolderUse::passed);
    return folder ? putInPlace(winOf(file), winOf(folder), to.filename().native()) : errno;
}

/// The file systems of Windows write the new name to their journal by themselves.
int renameDurably(const fs::path& from, const fs::path& to) {
    if (repeatsParent()) return 0;
    const File file = openExisting(from, GENERIC_WRITE, FILE_FLAG_OPEN_REPARSE_POINT);
    if (!file && errno != EACCES) return errno;  // a file that is only for reading is on the disk
    if (const int problem = file ? sync(file) : 0; problem != 0) return problem;
    return renameOver(from, to);
}

bool mustStay(const fs::path& path) {
    FileFacts old;
    if (factsOf(path, Links::notFollowed, old) != 0 || old.kind != FileKind::regular) return false;
    return old.names > 1 || !old.isOwn;  // keepAccess() copies access lists
}

int writeOver(const fs::path& path, std::span<const std::byte> bytes) {
    if (repeatsParent()) return 0;
    if (kindOf(path, Links::notFollowed) == FileKind::link) return ELOOP;
    const File file = openExisting(path, GENERIC_WRITE, 0);
    LARGE_INTEGER old{}, wanted{};
    if (!file || !::GetFileSizeEx(winOf(file), &old)) return file ? lastErrno() : errno;
    wanted.QuadPart = static_cast<LONGLONG>(bytes.size());
    const auto setSize = [&](const LARGE_INTEGER& size) {
        const bool isSet = ::SetFilePointerEx(winOf(file), size, nullptr, FILE_BEGIN) != 0 &&
                           ::SetEndOfFile(winOf(file)) != 0;
        return isSet ? 0 : lastErrno();
    };
    if (old.QuadPart < wanted.QuadPart)
        if (const int failed = setSize(wanted); failed != 0) {
            setSize(old);
            return failed;
        }
    if (!::SetFilePointerEx(winOf(file), {}, nullptr, FILE_BEGIN)) return lastErrno();
    if (const int failed = writeAll(file, bytes); failed != 0) return failed;
    return setSize(wanted);
}

/// An administrator's file belongs to whom the system gives it, whatever `keepsOwner` says.
void keepAccess(const fs::path& replaced, const fs::path& by, bool) {
    if (repeatsParent()) return;
    const File old = openExisting(replaced, kForAccess, FILE_FLAG_OPEN_REPARSE_POINT);
    const File made = openExisting(by, kForNewAccess, FILE_FLAG_OPEN_REPARSE_POINT);
    if (!old || !made || isLink(winOf(old)) || isLink(winOf(made))) return;
    keepAccessOf(winOf(old), winOf(made));
}

int removeTree(const fs::path& path) {
    if (repeatsParent()) return 0;
    std::error_code failure;
    fs::remove_all(path, failure);
    return failure.value();
}

int replaceUnnamed(const fs::path&, std::span<const std::byte>, bool) {
    return ENOTSUP;
}

// How a file takes the place of another one, and how files are removed. Windows refuses both for files that
// some program has open, unless a newer kind of request is known to the file system.

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

std::filesystem::path asInFolders(const std::filesystem::path& path) {
    if (!path.has_relative_path()) {
        std::wstring drive = path.native();
        ::CharUpperW(drive.data());
        return drive;
    }
    std::filesystem::path name = path.filename();
    WIN32_FIND_DATAW found{};
    const bool isName =
        name != L"." && name != L".." && name.native().find_first_of(L"*?") == std::wstring::npos;
    const HANDLE search = isName ? ::FindFirstFileW(pathText(path).c_str(), &found) : INVALID_HANDLE_VALUE;
    if (search != INVALID_HANDLE_VALUE) name = found.cFileName;
    ::FindClose(search);
    return asInFolders(path.parent_path()) / name;
}

}  // namespace glibra::system
