#include "system/folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>

#include "system/posix/extras.h"

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

int modeOf(FolderUse use) {
    return use == FolderUse::passed ? passingMode() : O_RDONLY;
}

/// A file for reading, which never blocks; no link.
File openIn(int folder, const char* name) {
    return File(::openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
}

void keepAccessOf(int folder, const fs::path& name, int file) {
    struct stat old{}, made{};
    if (::fstatat(folder, name.c_str(), &old, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(old.st_mode)) return;
    if (::fstat(file, &made) != 0 || old.st_uid != made.st_uid) return;
    const File replaced = openIn(folder, name.c_str());
    if (replaced && hasAccessList(numberOf(replaced))) return;
    constexpr mode_t kPermissions = S_IRWXU | S_IRWXG | S_IRWXO;
    mode_t mode = old.st_mode & kPermissions;
    // Another group has no more rights than everybody.
    if (old.st_gid != made.st_gid && ::fchown(file, made.st_uid, old.st_gid) != 0)
        mode &= ~static_cast<mode_t>(S_IRWXG) | ((mode & S_IRWXO) << 3U);
    if (mode == (made.st_mode & kPermissions)) return;
    // Where modes cannot be changed, as in a sandbox, the file keeps the mode that is usual for the user.
    static_cast<void>(::fchmod(file, mode));
}

void keepOwnerOf(const fs::path& replaced, int file) {
    struct stat old{};
    if (::geteuid() == 0 && ::lstat(replaced.c_str(), &old) == 0 && S_ISREG(old.st_mode) && old.st_uid != 0)
        static_cast<void>(::fchown(file, old.st_uid, static_cast<gid_t>(-1)));
}

}  // namespace

bool isPlainName(const std::string& name) {
    return !name.empty() && name != "." && name != ".." &&
           name.find_first_of(std::string_view("/\0", 2)) == name.npos;
}

File openFolder(const fs::path& folder, FolderUse use) {
    return File(::open(folder.empty() ? "." : folder.c_str(), modeOf(use) | O_DIRECTORY | O_CLOEXEC));
}

File openFolderIn(const File& folder, const std::string& name, FolderUse use) {
    struct stat status{};
    const bool isLink = ::fstatat(numberOf(folder), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
                        S_ISLNK(status.st_mode);
    File opened(::openat(numberOf(folder), name.c_str(), modeOf(use) | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (!opened && isLink) errno = ELOOP;
    return opened;
}

int makeFolderIn(const File& folder, const std::string& name) {
    return ::mkdirat(numberOf(folder), name.c_str(), 0777) == 0 || errno == EEXIST ? 0 : errno;
}

File openFileIn(const File& folder, const std::string& name) {
    File file = openIn(numberOf(folder), name.c_str());
    struct stat status{};
    if (file && ::fstat(numberOf(file), &status) == 0 && !S_ISREG(status.st_mode)) {
        errno = ENOTSUP;
        return {};
    }
    return file;
}

int removeIn(const File& folder, const std::string& name) {
    return ::unlinkat(numberOf(folder), name.c_str(), 0) == 0 ? 0 : errno;
}

int clearNameIn(const File& folder, const std::string& name) {
    struct stat status{};
    if (::fstatat(numberOf(folder), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT ? 0 : errno;
    return S_ISREG(status.st_mode) ? 0 : removeIn(folder, name);
}

int replaceIn(const File& folder, const std::string& name, std::span<const std::byte> bytes) {
    const int number = numberOf(folder);
    if (const File file(openUnnamed(number, ".", O_WRONLY, 0666)); file) {
        int problem = writeAll(file, bytes);
        if (problem == 0) problem = sync(file);
        if (problem == 0) keepAccessOf(number, name, numberOf(file));
        if (problem == 0) problem = nameFile(number, numberOf(file), name);
        if (problem == 0) return sync(folder);
        if (problem != ENOTSUP) return problem;
    }
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const std::string between =
            ".glibra-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        const File file(::openat(number, between.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file && errno == EEXIST) continue;
        if (!file) return errno;
        int problem = writeAll(file, bytes);
        keepAccessOf(number, name, numberOf(file));
        if (problem == 0) problem = sync(file);
        if (problem == 0 && ::renameat(number, between.c_str(), number, name.c_str()) != 0) problem = errno;
        if (problem == 0) return sync(folder);
        ::unlinkat(number, between.c_str(), 0);
        return problem;
    }
    return EEXIST;
}

int removeTree(const fs::path& path) {
    std::error_code failure;
    fs::remove_all(path, failure);
    return failure.value();
}

int renameOver(const fs::path& from, const fs::path& to) {
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

int renameDurably(const fs::path& from, const fs::path& to) {
    const File file(::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (!file) return errno;
    if (const int problem = sync(file); problem != 0) return problem;
    if (const int problem = renameOver(from, to); problem != 0) return problem;
    const File folder = openFolder(to.parent_path());
    return folder ? sync(folder) : errno;
}

bool mustStay(const fs::path& path) {
    FileFacts old;
    if (factsOf(path, Links::notFollowed, old) != 0 || old.kind != FileKind::regular) return false;
    if (old.names > 1 || (::geteuid() != 0 && !old.isOwn)) return true;
    const File file = openIn(AT_FDCWD, path.c_str());
    return file && hasAccessList(numberOf(file));
}

int writeOver(const fs::path& path, std::span<const std::byte> bytes) {
    const File file(::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat old{};
    if (!file || ::fstat(numberOf(file), &old) != 0) return errno;
    const auto size = static_cast<off_t>(bytes.size());
    if (size > old.st_size) {
        const int failed = ::posix_fallocate(numberOf(file), old.st_size, size - old.st_size);
        if (failed == ENOSPC || failed == EFBIG || failed == EDQUOT) {
            static_cast<void>(::ftruncate(numberOf(file), old.st_size));
            return failed;
        }
    }
    if (const int failed = writeAll(file, bytes); failed != 0) return failed;
    return ::ftruncate(numberOf(file), size) == 0 ? 0 : errno;
}

void keepAccess(const fs::path& replaced, const fs::path& by, bool keepsOwner) {
    const File file(::open(by.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (!file) return;
    if (keepsOwner) keepOwnerOf(replaced, numberOf(file));
    keepAccessOf(AT_FDCWD, replaced, numberOf(file));
}

int replaceUnnamed(const fs::path& path, std::span<const std::byte> bytes, bool keepsOwner) {
    const File folder = openFolder(path.parent_path());
    if (!folder) return ENOTSUP;  // the named file reports it
    const File file(openUnnamed(numberOf(folder), ".", O_WRONLY, 0666));
    if (!file) return ENOTSUP;
    if (const int failed = writeAll(file, bytes); failed != 0) return failed;
    if (keepsOwner) keepOwnerOf(path, numberOf(file));
    keepAccessOf(numberOf(folder), path.filename(), numberOf(file));
    return nameFile(numberOf(folder), numberOf(file), path.filename());
}

std::filesystem::path asInFolders(const std::filesystem::path& path) {
    return path;
}

}  // namespace glibra::system
