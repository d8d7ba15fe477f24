#include "system/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "system/posix/extras.h"

namespace glibra::system {

namespace fs = std::filesystem;

namespace {

/// What stat() or the like has found.
int take(int result, const struct stat& status, FileFacts& facts) {
    facts = {};
    if (result != 0) return errno;
    facts.kind = S_ISREG(status.st_mode)   ? FileKind::regular
                 : S_ISDIR(status.st_mode) ? FileKind::folder
                 : S_ISLNK(status.st_mode) ? FileKind::link
                                           : FileKind::other;
    facts.size = static_cast<std::uint64_t>(status.st_size);
    facts.names = status.st_nlink;
    facts.isOwn = status.st_uid == ::geteuid();
    facts.device = status.st_dev;
    facts.number = status.st_ino;
    facts.seconds = status.st_mtim.tv_sec;
    facts.nanoseconds = status.st_mtim.tv_nsec;
    return 0;
}

}  // namespace

File::~File() {
    const int problem = errno;  // the caller still needs it
    close();
    errno = problem;
}

int File::close() {
    if (handle_ == kNoHandle) return 0;
    return ::close(static_cast<int>(std::exchange(handle_, kNoHandle))) == 0 ? 0 : errno;
}

int factsOf(const fs::path& path, Links links, FileFacts& facts) {
    struct stat status{};
    const int result =
        links == Links::followed ? ::stat(path.c_str(), &status) : ::lstat(path.c_str(), &status);
    return take(result, status, facts);
}

int factsOf(const File& file, FileFacts& facts) {
    struct stat status{};
    return take(::fstat(numberOf(file), &status), status, facts);
}

File openToRead(const fs::path& path, Links links) {
    // Without O_NONBLOCK, opening a pipe blocks until somebody writes to it.
    const int follow = links == Links::followed ? 0 : O_NOFOLLOW;
    return File(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | follow));
}

File openToOverwrite(const fs::path& path) {
    return File(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
}

File openToAppend(const fs::path& path) {
    return File(::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW));
}

File makeNewFile(const fs::path& path) {
    return File(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
}

int makePrivateFolder(const fs::path& path) {
    return ::mkdir(path.c_str(), 0700) == 0 ? 0 : errno;
}

int writeAll(const File& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(numberOf(file), bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return 0;
}

int appendWhole(const File& file, std::string_view text) {
    const off_t before = ::lseek(numberOf(file), 0, SEEK_END);
    while (!text.empty()) {
        const ssize_t count = ::write(numberOf(file), text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int problem = count < 0 ? errno : ENOSPC;
            if (before >= 0 && ::ftruncate(numberOf(file), before) != 0) return problem;
            return problem;
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return 0;
}

int readFull(const File& file, std::span<std::byte> bytes, std::size_t& count) {
    count = 0;
    while (count < bytes.size()) {
        const ssize_t got = ::read(numberOf(file), bytes.data() + count, bytes.size() - count);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        if (got == 0) break;
        count += static_cast<std::size_t>(got);
    }
    return 0;
}

bool receiveAll(const File& pipe, std::span<std::byte> bytes) {
    std::size_t count = 0;
    return readFull(pipe, bytes, count) == 0 && count == bytes.size();
}

int sync(const File& file) {
    return ::fsync(numberOf(file)) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
}

void syncContent(const File& file) {
    ::fdatasync(numberOf(file));
}

int makePipe(File& reading, File& writing) {
    int ends[2];
    if (!openPipe(ends)) return errno;
    reading = File(ends[0]);
    writing = File(ends[1]);
    return 0;
}

void reserveLarge(std::vector<std::byte>& bytes, std::size_t size) {
    bytes.reserve(size);
#ifdef MADV_HUGEPAGE
    constexpr std::size_t kLeast = std::size_t{8} << 20;
    if (size < kLeast) return;
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    void* begin = bytes.data();
    std::size_t space = size;
    if (std::align(page, page, begin, space) != nullptr)
        ::madvise(begin, space / page * page, MADV_HUGEPAGE);  // only a hint, so the result does not matter
#endif
}

Lock::Try Lock::takeFolder(const fs::path& folder, Wait wait) {
    file_ = File(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file_) return Try::missing;
    owner_ = ::getpid();
    isTaken_ = ::flock(numberOf(file_), LOCK_EX | (wait == Wait::no ? LOCK_NB : 0)) == 0;
    return isTaken_ ? Try::taken : errno == EWOULDBLOCK ? Try::held : Try::none;
}

Lock::Try Lock::takeNewFile(const fs::path& file) {
    file_ = File(::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (!file_) return Try::missing;
    owner_ = ::getpid();
    // Another process may have removed it before it was locked.
    FileFacts locked, named;
    isTaken_ = ::flock(numberOf(file_), LOCK_EX | LOCK_NB) == 0 && factsOf(file_, locked) == 0 &&
               factsOf(file, Links::followed, named) == 0 && locked.number == named.number &&
               locked.device == named.device;
    if (!isTaken_) file_.close();
    return isTaken_ ? Try::taken : Try::held;
}

void Lock::release() {
    // A process that was forked meanwhile shares the lock. Closing alone would leave the lock with it, and
    // that process must not release it.
    if (file_ && ::getpid() == owner_) ::flock(numberOf(file_), LOCK_UN);
    file_.close();
    isTaken_ = false;
}

bool removeUnlessLocked(const fs::path& file) {
    const File opened(::open(file.c_str(), O_RDWR | O_CLOEXEC));
    if (!opened) return false;
    if (::flock(numberOf(opened), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return true;
    ::unlink(file.c_str());
    return false;
}

}  // namespace glibra::system
