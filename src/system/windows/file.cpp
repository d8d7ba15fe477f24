#include "system/file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "system/windows/win.h"

#include <aclapi.h>
#include <sddl.h>

namespace glibra::system {

namespace fs = std::filesystem;

namespace {

/// Bytes of one call, which takes 32 bits.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 26U;

std::uint64_t joined(DWORD high, DWORD low) {
    return std::uint64_t{high} << 32U | low;
}

void takeTime(const FILETIME& time, FileFacts& facts) {
    constexpr std::int64_t kTicks = 10'000'000;          // of 100 ns in a second
    constexpr std::int64_t kUntil1970 = 11'644'473'600;  // seconds since 1601
    const auto ticks = static_cast<std::int64_t>(joined(time.dwHighDateTime, time.dwLowDateTime));
    facts.seconds = ticks / kTicks - kUntil1970;
    facts.nanoseconds = ticks % kTicks * 100;
}

int takeFacts(HANDLE file, FileFacts& facts) {
    facts = {};
    BY_HANDLE_FILE_INFORMATION found{};
    const DWORD type = ::GetFileType(file);
    if (type == FILE_TYPE_PIPE || type == FILE_TYPE_CHAR) {
        facts.kind = FileKind::other;
        return 0;
    }
    if (!::GetFileInformationByHandle(file, &found)) return lastErrno();
    facts.kind = isLink(file)                                               ? FileKind::link
                 : (found.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileKind::folder
                                                                            : FileKind::regular;
    facts.size = joined(found.nFileSizeHigh, found.nFileSizeLow);
    facts.names = found.nNumberOfLinks;
    facts.isOwn = isOwn(file);
    facts.device = found.dwVolumeSerialNumber;
    facts.number = joined(found.nFileIndexHigh, found.nFileIndexLow);
    takeTime(found.ftLastWriteTime, facts);
    return 0;
}

DWORD writeOnce(HANDLE file, std::span<const std::byte> bytes, std::size_t& count) {
    DWORD written = 0;
    const auto size = static_cast<DWORD>(std::min(bytes.size(), kMostAtOnce));
    BOOL isDone = FALSE;
    if (::GetFileType(file) == FILE_TYPE_PIPE) {
        Pending pending;
        isDone = ::WriteFile(file, bytes.data(), size, nullptr, &pending.state);
        if (isDone || ::GetLastError() == ERROR_IO_PENDING)
            isDone = ::GetOverlappedResult(file, &pending.state, &written, TRUE);
    } else {
        isDone = ::WriteFile(file, bytes.data(), size, &written, nullptr);
    }
    count = written;
    return isDone ? ERROR_SUCCESS : ::GetLastError();
}

}  // namespace

File::~File() {
    const int problem = errno;  // the caller still needs it
    const DWORD error = ::GetLastError();
    close();
    errno = problem;
    ::SetLastError(error);
}

int File::close() {
    if (handle_ == kNoHandle) return 0;
    return ::CloseHandle(reinterpret_cast<HANDLE>(std::exchange(handle_, kNoHandle))) ? 0 : lastErrno();
}

File openExisting(const fs::path& path, DWORD access, DWORD flags, DWORD share) {
    return ownOrErrno(::CreateFileW(pathText(path).c_str(), access, share, nullptr, OPEN_EXISTING,
                                    flags | SECURITY_SQOS_PRESENT | SECURITY_IDENTIFICATION, nullptr));
}

bool isLink(HANDLE file) {
    FILE_ATTRIBUTE_TAG_INFO found{};
    return ::GetFileInformationByHandleEx(file, FileAttributeTagInfo, &found, sizeof found) &&
           (found.FileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 &&
           (found.ReparseTag == IO_REPARSE_TAG_SYMLINK || found.ReparseTag == IO_REPARSE_TAG_MOUNT_POINT);
}

bool isSame(HANDLE first, HANDLE second) {
    BY_HANDLE_FILE_INFORMATION a{}, b{};
    return ::GetFileInformationByHandle(first, &a) && ::GetFileInformationByHandle(second, &b) &&
           a.dwVolumeSerialNumber == b.dwVolumeSerialNumber && a.nFileIndexHigh == b.nFileIndexHigh &&
           a.nFileIndexLow == b.nFileIndexLow;
}

DWORD readOnce(HANDLE from, void* to, std::size_t most, std::size_t& count) {
    DWORD got = 0;
    const auto size = static_cast<DWORD>(std::min(most, kMostAtOnce));
    BOOL isDone = FALSE;
    if (::GetFileType(from) == FILE_TYPE_PIPE) {
        Pending pending;
        isDone = ::ReadFile(from, to, size, nullptr, &pending.state);
        if (isDone || ::GetLastError() == ERROR_IO_PENDING)
            isDone = ::GetOverlappedResult(from, &pending.state, &got, TRUE);
    } else {
        isDone = ::ReadFile(from, to, size, &got, nullptr);
    }
    count = got;
    const DWORD error = isDone ? ERROR_SUCCESS : ::GetLastError();
    const bool isEnd = error == ERROR_BROKEN_PIPE || error == ERROR_HANDLE_EOF;
    return isEnd ? DWORD{ERROR_SUCCESS} : error;
}

int factsOf(const fs::path& path, Links links, FileFacts& facts) {
    const DWORD flags =
        FILE_FLAG_BACKUP_SEMANTICS | (links == Links::followed ? 0 : FILE_FLAG_OPEN_REPARSE_POINT);
    facts = {};
    File file = openExisting(path, FILE_READ_ATTRIBUTES | READ_CONTROL, flags);
    // Who may see a file may not see to whom it belongs.
    if (!file && errno == EACCES) file = openExisting(path, FILE_READ_ATTRIBUTES, flags);
    return file ? takeFacts(winOf(file), facts) : errno;
}

int factsOf(const File& file, FileFacts& facts) {
    return takeFacts(winOf(file), facts);
}

/// Opens a file that is no link. It is opened twice: a handle to a link itself would also be one to the
/// placeholder of a file in a cloud, which has no content.
static File openUnlessLink(const fs::path& path, DWORD access) {
    const File named =
        openExisting(path, FILE_READ_ATTRIBUTES, FILE_FLAG_BACKUP_SEMANTICS | FILE_FLAG_OPEN_REPARSE_POINT);
    if (!named) return {};
    File file;
    if (!isLink(winOf(named)))
        file = openExisting(path, access, FILE_FLAG_BACKUP_SEMANTICS);
    else
        errno = ELOOP;
    if (file && ::GetFileType(winOf(file)) == FILE_TYPE_DISK && !isSame(winOf(named), winOf(file))) {
        errno = ELOOP;  // somebody has put a link there meanwhile
        return {};
    }
    return file;
}

File openToRead(const fs::path& path, Links links) {
    if (links == Links::notFollowed) return openUnlessLink(path, GENERIC_READ);
    return openExisting(path, GENERIC_READ, FILE_FLAG_BACKUP_SEMANTICS);
}

File nullDevice() {
    return openExisting(L"NUL", GENERIC_READ | GENERIC_WRITE, 0);
}

File openToOverwrite(const fs::path& path) {
    if (repeatsParent()) return nullDevice();
    return openExisting(path, GENERIC_WRITE, 0);
}

File openToAppend(const fs::path& path) {
    if (repeatsParent()) return nullDevice();
    return openUnlessLink(path, GENERIC_READ | FILE_APPEND_DATA);
}

File makeNewFile(const fs::path& path) {
    if (repeatsParent()) return nullDevice();
    // It can be renamed while it is open.
    return ownOrErrno(::CreateFileW(pathText(path).c_str(), GENERIC_WRITE | FILE_READ_ATTRIBUTES, kShareAll,
                                    nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr));
}

int makePrivateFolder(const fs::path& path) {
    if (repeatsParent()) return kindOf(path, Links::notFollowed) == FileKind::folder ? 0 : ENOENT;
    PrivateAccess access;
    return ::CreateDirectoryW(pathText(path).c_str(), access.attributes()) ? 0 : lastErrno();
}

int writeAll(const File& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        std::size_t count = 0;
        if (const DWORD error = writeOnce(winOf(file), bytes, count); error != ERROR_SUCCESS)
            return errnoOf(error);
        bytes = bytes.subspan(count);
    }
    return 0;
}

int appendWhole(const File& file, std::string_view text) {
    LARGE_INTEGER before{};
    const bool isKnown = ::GetFileSizeEx(winOf(file), &before) != 0;
    const int problem = writeAll(file, text);
    if (problem == 0 || !isKnown) return problem;
    // The handle may only append.
    const File whole = ownOf(::ReOpenFile(winOf(file), GENERIC_WRITE, kShareAll, 0));
    if (whole && ::SetFilePointerEx(winOf(whole), before, nullptr, FILE_BEGIN)) ::SetEndOfFile(winOf(whole));
    return problem;
}

int readFull(const File& file, std::span<std::byte> bytes, std::size_t& count) {
    count = 0;
    while (count < bytes.size()) {
        std::size_t got = 0;
        const DWORD error = readOnce(winOf(file), bytes.data() + count, bytes.size() - count, got);
        if (error != ERROR_SUCCESS) return errnoOf(error);
        if (got == 0) break;
        count += got;
    }
    return 0;
}

bool receiveAll(const File& pipe, std::span<std::byte> bytes) {
    std::size_t count = 0;
    return readFull(pipe, bytes, count) == 0 && count == bytes.size();
}

int sync(const File& file) {
    if (::FlushFileBuffers(winOf(file))) return 0;
    const DWORD error = ::GetLastError();
    // Consoles and pipes have no disk; a folder, and a file that is open for reading, are not flushed.
    const bool hasNone = error == ERROR_INVALID_FUNCTION || error == ERROR_INVALID_HANDLE ||
                         error == ERROR_NOT_SUPPORTED || error == ERROR_ACCESS_DENIED;
    return hasNone ? 0 : errnoOf(error);
}

void syncContent(const File& file) {
    sync(file);
}

int makePipe(File& reading, File& writing) {
    return makePipeEnds(PipeEnd::reads, reading, writing);
}

/// Windows gives large pages only to those who have the right to lock memory.
void reserveLarge(std::vector<std::byte>& bytes, std::size_t size) {
    bytes.reserve(size);
}

// To whom files belong, and who may use them.

namespace {

/// A part of what the system knows of the user of this process, as Part, which begins in `bytes`.
template <class Part>
struct OfUser {
    explicit OfUser(TOKEN_INFORMATION_CLASS which) {
        HANDLE token = nullptr;
        if (!::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &token)) return;
        const File open = ownOf(token);
        DWORD size = 0;
        isKnown = ::GetTokenInformation(token, which, bytes.data(), static_cast<DWORD>(bytes.size()), &size);
    }
    [[nodiscard]] const Part* part() const {
        return isKnown ? reinterpret_cast<const Part*>(bytes.data()) : nullptr;
    }
    alignas(Part) std::array<std::byte, sizeof(Part) + SECURITY_MAX_SID_SIZE> bytes{};
    bool isKnown = false;
};

/// The list of a file, which LocalFree() gives back; null if there is none.
struct AccessOf {
    AccessOf(HANDLE file, SECURITY_INFORMATION what) {
        if (::GetSecurityInfo(file, SE_FILE_OBJECT, what, &owner, nullptr, &list, nullptr, &descriptor) !=
            ERROR_SUCCESS)
            descriptor = nullptr;
    }
    AccessOf(const AccessOf&) = delete;
    AccessOf& operator=(const AccessOf&) = delete;
    ~AccessOf() { ::LocalFree(descriptor); }
    PSID owner = nullptr;
    PACL list = nullptr;
    PSECURITY_DESCRIPTOR descriptor = nullptr;
};

}  // namespace

bool isOwn(HANDLE file) {
    static const OfUser<TOKEN_USER> user(TokenUser);
    static const OfUser<TOKEN_OWNER> maker(TokenOwner);  // for an administrator it may be their group
    const AccessOf access(file, OWNER_SECURITY_INFORMATION);
    if (access.descriptor == nullptr || access.owner == nullptr) return false;
    return (user.part() != nullptr && ::EqualSid(access.owner, user.part()->User.Sid)) ||
           (maker.part() != nullptr && ::EqualSid(access.owner, maker.part()->Owner));
}

void copyAccessList(HANDLE from, HANDLE to) {
    const AccessOf access(from, DACL_SECURITY_INFORMATION);
    SECURITY_DESCRIPTOR_CONTROL control = 0;
    DWORD revision = 0;
    if (access.descriptor == nullptr || access.list == nullptr ||
        !::GetSecurityDescriptorControl(access.descriptor, &control, &revision))
        return;
    // The entries that the old file has inherited are made again from the folder.
    const SECURITY_INFORMATION inheriting = (control & SE_DACL_PROTECTED) != 0
                                                ? PROTECTED_DACL_SECURITY_INFORMATION
                                                : UNPROTECTED_DACL_SECURITY_INFORMATION;
    ::SetSecurityInfo(to, SE_FILE_OBJECT, DACL_SECURITY_INFORMATION | inheriting, nullptr, nullptr,
                      access.list, nullptr);
}

PrivateAccess::PrivateAccess() {
    const OfUser<TOKEN_USER> user(TokenUser);
    wchar_t* name = nullptr;
    if (user.part() == nullptr || !::ConvertSidToStringSidW(user.part()->User.Sid, &name)) return;
    // Nothing from the folder above; all rights for the user and for the system, also below.
    const std::wstring text = std::wstring(L"D:P(A;OICI;FA;;;") + name + L")(A;OICI;FA;;;SY)";
    ::LocalFree(name);
    if (!::ConvertStringSecurityDescriptorToSecurityDescriptorW(text.c_str(), SDDL_REVISION_1, &list_,
                                                                nullptr))
        list_ = nullptr;
    attributes_ = {sizeof attributes_, list_, FALSE};
}

PrivateAccess::~PrivateAccess() {
    ::LocalFree(list_);
}

// Locks are files that are open without sharing: whoever opens them next fails until the first one closes
// them or ends.

/// A folder is locked by a file in it, which the system removes when it is closed, however that comes.
Lock::Try Lock::takeFolder(const fs::path& folder, Wait wait) {
    release();
    if (repeatsParent()) return Try::taken;
    if (kindOf(folder, Links::followed) != FileKind::folder) return Try::missing;
    const fs::path file = folder / L".glibra-lock";
    constexpr DWORD kPause = 10;
    constexpr int kMostRefused = 10;
    for (int refused = 0;;) {
        file_ = ownOf(::CreateFileW(pathText(file).c_str(), GENERIC_WRITE | DELETE, 0, nullptr, OPEN_ALWAYS,
                                    FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr));
        isTaken_ = static_cast<bool>(file_);
        if (isTaken_) return Try::taken;
        // For a moment, a file that is being removed cannot be opened either; for longer, only one in a
        // folder where this user may make none.
        const bool isHeld = ::GetLastError() == ERROR_SHARING_VIOLATION;
        if (isHeld && wait == Wait::no) return Try::held;
        if (!isHeld && (::GetLastError() != ERROR_ACCESS_DENIED || ++refused > kMostRefused))
            return Try::none;
        ::Sleep(kPause);
    }
}

Lock::Try Lock::takeNewFile(const fs::path& file) {
    release();
    if (repeatsParent()) return Try::taken;
    PrivateAccess access;
    // Others may read it; they cannot remove it.
    file_ = ownOrErrno(::CreateFileW(pathText(file).c_str(), GENERIC_READ | GENERIC_WRITE,
                                     FILE_SHARE_READ | FILE_SHARE_WRITE, access.attributes(), CREATE_NEW,
                                     FILE_ATTRIBUTE_NORMAL, nullptr));
    owner_ = ownNumber();
    isTaken_ = static_cast<bool>(file_);
    return isTaken_ ? Try::taken : Try::missing;
}

void Lock::release() {
    file_.close();
    isTaken_ = false;
}

bool removeUnlessLocked(const fs::path& file) {
    if (repeatsParent()) return false;
    const File opened = openExisting(file, DELETE, FILE_FLAG_OPEN_REPARSE_POINT);
    if (!opened) return ::GetLastError() == ERROR_SHARING_VIOLATION;
    removeOpen(winOf(opened));
    return false;
}

}  // namespace glibra::system
