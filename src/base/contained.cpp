#include "base/contained.h"

#include <fcntl.h>
#include <sys/stat.h>
#ifdef __linux__
#include <sys/xattr.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iterator>
#include <new>
#include <system_error>
#include <utility>

namespace glibra::base {
namespace {

namespace fs = std::filesystem;

/// The parts of a path that leads downwards; none if it does not.
std::vector<std::string> downwards(const fs::path& path) {
    std::vector<std::string> parts;
    if (path.is_absolute()) return {};
    for (const fs::path& each : path) {
        if (each == "..") return {};
        if (each.native().find('\0') != std::string::npos) return {};
        if (!each.empty() && each != ".") parts.push_back(each.string());
    }
    return parts;
}

/// How a folder is opened that is only gone through: in a sandbox some can be passed and not be listed.
#ifdef O_PATH
constexpr int kPassing = O_PATH;
#else
constexpr int kPassing = O_RDONLY;
#endif

Descriptor openFolder(const fs::path& folder, int access = O_RDONLY) {
    return Descriptor(::open(folder.empty() ? "." : folder.c_str(), access | O_DIRECTORY | O_CLOEXEC));
}

/// Goes down the folders of `parts`, all but the last. Each is opened from the one before, so that nobody can
/// put a link in between. errno says why there is no value.
Descriptor enter(const fs::path& root, const std::vector<std::string>& parts, bool make,
                 int access = O_RDONLY) {
    if (parts.empty()) {
        errno = EINVAL;
        return {};
    }
    std::error_code unmade;
    if (make && !root.empty()) fs::create_directories(root, unmade);
    Descriptor folder = openFolder(root, access);
    if (!folder && unmade) errno = unmade.value();
    for (std::size_t i = 0; folder && i + 1 < parts.size(); ++i) {
        const int problem =
            make && ::mkdirat(folder.number(), parts[i].c_str(), 0777) != 0 && errno != EEXIST ? errno : 0;
        struct stat status{};
        const bool isLink = ::fstatat(folder.number(), parts[i].c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
                            S_ISLNK(status.st_mode);
        Descriptor next(
            ::openat(folder.number(), parts[i].c_str(), access | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (!next && (isLink || problem != 0)) errno = isLink ? ELOOP : problem;
        folder = std::move(next);
    }
    return folder;
}

/// Writes to the disk what the system holds of a file. File systems without that cannot lose it either.
int sync(int file) {
    return ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS ? 0 : errno;
}

bool isHidden(const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return part.native().starts_with('.'); });
}

}  // namespace

Descriptor openBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const Descriptor folder = enter(root, parts, false, kPassing);
    if (!folder) return {};
    // Without O_NONBLOCK, opening a pipe blocks until somebody writes to it.
    Descriptor file(
        ::openat(folder.number(), parts.back().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status{};
    if (file && ::fstat(file.number(), &status) == 0 && !S_ISREG(status.st_mode)) {
        errno = ENOTSUP;
        return {};
    }
    return file;
}

int readAll(const Descriptor& file, std::uint64_t largest, std::vector<std::byte>& bytes) {
    struct stat status{};
    if (::fstat(file.number(), &status) != 0) return errno;
    if (static_cast<std::uint64_t>(status.st_size) > largest) return EFBIG;
    try {
        bytes.resize(static_cast<std::size_t>(status.st_size));
    } catch (const std::bad_alloc&) {
        return ENOMEM;
    }
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file.number(), bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno;
        if (got == 0) break;  // the file has become shorter meanwhile
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return 0;
}

int makeFoldersBeneath(const fs::path& root, const fs::path& path) {
    std::vector<std::string> parts = downwards(path);
    if (parts.empty() && !path.empty() && path != ".") return EINVAL;
    parts.emplace_back();  // the name of a file in the last folder
    return enter(root, parts, true) ? 0 : errno;
}

bool hasAccessList([[maybe_unused]] int file) {
#ifdef __linux__
    return ::fgetxattr(file, "system.posix_acl_access", nullptr, 0) > 0;
#else
    return false;
#endif
}

void keepAccess(int folder, const fs::path& name, int file) {
    struct stat old{}, made{};
    if (::fstatat(folder, name.c_str(), &old, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(old.st_mode)) return;
    if (::fstat(file, &made) != 0 || old.st_uid != made.st_uid) return;
    const Descriptor replaced(::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (replaced && hasAccessList(replaced.number())) return;
    constexpr mode_t kPermissions = S_IRWXU | S_IRWXG | S_IRWXO;
    mode_t mode = old.st_mode & kPermissions;
    // Another group has no more rights than everybody.
    if (old.st_gid != made.st_gid && ::fchown(file, made.st_uid, old.st_gid) != 0)
        mode &= ~static_cast<mode_t>(S_IRWXG) | ((mode & S_IRWXO) << 3U);
    if (mode == (made.st_mode & kPermissions)) return;
    // Where modes cannot be changed, as in a sandbox, the file keeps the mode that is usual for the user.
    static_cast<void>(::fchmod(file, mode));
}

int nameFile([[maybe_unused]] int folder, [[maybe_unused]] int file, [[maybe_unused]] const fs::path& name) {
#ifdef O_TMPFILE
    keepAccess(folder, name, file);
    const std::string open = "/proc/self/fd/" + std::to_string(file);
    int problem = EEXIST;
    constexpr int kAttempts = 1000;
    for (int attempt = 0; problem == EEXIST && attempt < kAttempts; ++attempt) {
        // A link cannot replace a file, but renaming can, and it is what others watch for. The name exists
        // only between these two calls.
        const std::string between =
            ".glibra-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        problem =
            ::linkat(AT_FDCWD, open.c_str(), folder, between.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
        if (problem != 0) continue;
        if (::renameat(folder, between.c_str(), folder, name.c_str()) == 0) return 0;
        problem = errno;
        ::unlinkat(folder, between.c_str(), 0);
        return problem;
    }
    // No /proc, a file system without links, a sandbox
    constexpr int kImpossible[] = {ENOENT, EPERM, ENOSYS, EXDEV, ENOTSUP, EINVAL, EACCES};
    return std::ranges::find(kImpossible, problem) != std::end(kImpossible) ? ENOTSUP : problem;
#else
    return ENOTSUP;
#endif
}

int writeBeneath(const fs::path& root, const fs::path& path, std::span<const std::byte> bytes) {
    const std::vector<std::string> parts = downwards(path);
    const Descriptor folder = enter(root, parts, true);
    if (!folder) return errno;
#ifdef O_TMPFILE
    if (const Descriptor file(::openat(folder.number(), ".", O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666)); file) {
        int problem = writeAll(file.number(), bytes);
        if (problem == 0) problem = sync(file.number());
        if (problem == 0) problem = nameFile(folder.number(), file.number(), parts.back());
        if (problem == 0) return sync(folder.number());
        if (problem != ENOTSUP) return problem;
    }
#endif
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const std::string name =
            ".glibra-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".tmp";
        const Descriptor file(
            ::openat(folder.number(), name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
        if (!file && errno == EEXIST) continue;
        if (!file) return errno;
        int problem = writeAll(file.number(), bytes);
        keepAccess(folder.number(), parts.back(), file.number());
        if (problem == 0) problem = sync(file.number());
        if (problem == 0 &&
            ::renameat(folder.number(), name.c_str(), folder.number(), parts.back().c_str()) != 0)
            problem = errno;
        if (problem == 0) return sync(folder.number());
        ::unlinkat(folder.number(), name.c_str(), 0);
        return problem;
    }
    return EEXIST;
}

int prepareBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const Descriptor folder = enter(root, parts, true);
    if (!folder) return errno;
    struct stat status{};
    if (::fstatat(folder.number(), parts.back().c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0)
        return errno == ENOENT ? 0 : errno;
    if (S_ISREG(status.st_mode)) return 0;
    return ::unlinkat(folder.number(), parts.back().c_str(), 0) == 0 ? 0 : errno;
}

int removeBeneath(const fs::path& root, const fs::path& path) {
    const std::vector<std::string> parts = downwards(path);
    const Descriptor folder = enter(root, parts, false);
    return folder && ::unlinkat(folder.number(), parts.back().c_str(), 0) == 0 ? 0 : errno;
}

int renameDurably(const fs::path& from, const fs::path& to) {
    const Descriptor file(::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (!file) return errno;
    if (const int problem = sync(file.number()); problem != 0) return problem;
    if (::rename(from.c_str(), to.c_str()) != 0) return errno;
    const Descriptor folder = openFolder(to.parent_path());
    return folder ? sync(folder.number()) : errno;
}

void Roots::add(const fs::path& folder) {
    const auto put = [&](const fs::path& each) {
        if (std::find(folders_.begin(), folders_.end(), each) == folders_.end()) folders_.push_back(each);
    };
    std::error_code failed;
    const fs::path resolved = fs::canonical(folder.empty() ? "." : folder, failed);
    if (failed || !fs::is_directory(resolved, failed)) return;
    put(resolved);
    fs::path named = fs::absolute(folder, failed).lexically_normal();
    if (!named.has_filename()) named = named.parent_path();
    if (!failed) put(named);
}

void Roots::addBelow(const fs::path& root, const fs::path& folder) {
    Roots outer;
    outer.add(root);
    if (outer.contains(folder)) add(folder);
}

bool Roots::contains(const fs::path& file) const {
    std::error_code failed;
    const fs::path resolved = fs::canonical(file, failed);
    if (failed) return false;
    return std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& root) {
        const fs::path inside = resolved.lexically_relative(root);
        return !inside.empty() && !isHidden(inside);  // "." and ".." begin with a dot too
    });
}

Descriptor Roots::open(const fs::path& file) const {
    std::error_code failed;
    const fs::path named = fs::absolute(file, failed).lexically_normal();
    int problem = EACCES;
    for (const fs::path& root : folders_) {
        const fs::path inside = named.lexically_relative(root);
        if (failed || inside.empty() || isHidden(inside)) continue;
        if (Descriptor opened = openBeneath(root, inside)) return opened;
        problem = errno;
    }
    errno = problem;
    return {};
}

}  // namespace glibra::base
