#include "system/file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "system/windows/win.h"

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

}  // namespace glibra::system
