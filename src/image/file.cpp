#include "image/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>

#include "base/contained.h"
#include "base/text.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;
using base::Descriptor;
using base::writeAll;

/// The system's text for an error number, as part of a sentence.
std::string reason(int number) {
    std::string text = std::generic_category().message(number);
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    return text;
}

/// Requests memory of `size` bytes without touching it, in pages of 2 MiB if the system has them: page faults
/// of small pages took half of the reading time of a large file.
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

/// The path that will be replaced: the target of a link, otherwise the path itself.
fs::path resolved(const fs::path& path) {
    std::error_code failed;
    if (!fs::is_symlink(path, failed)) return path;
    const fs::path target = fs::weakly_canonical(path, failed);
    return failed ? path : target;
}

/// True for a link that leads to itself. Nothing can be written through it, and it is not replaced.
bool leadsNowhere(const fs::path& path, NamedBy named) {
    struct stat status{};
    return named == NamedBy::user && ::stat(path.c_str(), &status) != 0 && errno == ELOOP;
}

/// True for a file that keeps its owner, its names and its access list only if it is written over.
bool mustStay(const fs::path& target, NamedBy named) {
    struct stat old{};
    if (named == NamedBy::program || ::lstat(target.c_str(), &old) != 0 || !S_ISREG(old.st_mode))
        return false;
    if (old.st_nlink > 1 || (::geteuid() != 0 && old.st_uid != ::geteuid())) return true;
    const Descriptor file(::open(target.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    return file.number() >= 0 && base::hasAccessList(file.number());
}

/// Writes over an existing file. Room for it is reserved first, so that a full disk leaves the old content.
/// Returns 0 or an error number.
int writeOver(const fs::path& target, std::span<const std::byte> bytes) {
    const Descriptor file(::open(target.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat old{};
    if (file.number() < 0 || ::fstat(file.number(), &old) != 0) return errno;
    const auto size = static_cast<off_t>(bytes.size());
    if (size > old.st_size) {
        const int failed = ::posix_fallocate(file.number(), old.st_size, size - old.st_size);
        if (failed == ENOSPC || failed == EFBIG || failed == EDQUOT) {
            static_cast<void>(::ftruncate(file.number(), old.st_size));
            return failed;
        }
    }
    if (const int failed = writeAll(file.number(), bytes); failed != 0) return failed;
    return ::ftruncate(file.number(), size) == 0 ? 0 : errno;
}

/// True if an error number of writeOver says that the file may only be replaced.
bool mayNotWrite(int number) {
    return number == EACCES || number == EPERM;
}

/// For the administrator, who may write the files of others.
void keepOwner(const fs::path& target, NamedBy named, int file) {
    struct stat old{};
    if (named == NamedBy::user && ::geteuid() == 0 && ::lstat(target.c_str(), &old) == 0 &&
        S_ISREG(old.st_mode) && old.st_uid != 0)
        static_cast<void>(::fchown(file, old.st_uid, static_cast<gid_t>(-1)));
}

}  // namespace

Result<std::vector<std::byte>> readFile(const base::FileSource& source, const FileLabel& label,
                                        std::uint64_t largest) {
    const auto unreadable = [&](const std::string& why) {
        return diagnose("file-E14", fmt::format("cannot read '{}': {}", label.name, why), label.place);
    };
    const auto wrongSize = [&](std::uint64_t size) -> std::optional<Diagnostic> {
        if (size == 0) return diagnose("file-E02", fmt::format("'{}' is empty", label.name), label.place);
        if (size <= largest) return std::nullopt;
        return diagnose("file-E09",
                        fmt::format("'{}' has {}, the limit is {}", label.name, base::readableBytes(size),
                                    base::readableBytes(largest)),
                        label.place);
    };
    if (source.content) {
        if (auto wrong = wrongSize(source.content->size())) return std::move(*wrong);
        const auto* const begin = reinterpret_cast<const std::byte*>(source.content->data());
        return std::vector<std::byte>(begin, begin + source.content->size());
    }
    // Without O_NONBLOCK, opening a pipe blocks until somebody writes to it.
    const Descriptor file(::open(source.path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0 && (errno == ENOENT || errno == ENOTDIR))
        return about(diagnose("file-E01", fmt::format("cannot find '{}'", label.name), label.place),
                     label.name);
    struct stat status{};
    if (file.number() < 0 || ::fstat(file.number(), &status) != 0) return unreadable(reason(errno));
    if (S_ISDIR(status.st_mode)) return unreadable("it is a folder");
    if (!S_ISREG(status.st_mode)) return unreadable("it is not an ordinary file");
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (auto wrong = wrongSize(size)) return std::move(*wrong);

    std::vector<std::byte> bytes;
    try {
        reserveLarge(bytes, size);
        bytes.resize(size);
    } catch (const std::bad_alloc&) {
        return unreadable("there is not enough memory");
    }
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got = ::read(file.number(), bytes.data() + have, bytes.size() - have);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return unreadable(reason(errno));
        if (got == 0) break;  // the file has become shorter meanwhile; the reader of its format reports that
        have += static_cast<std::size_t>(got);
    }
    bytes.resize(have);
    return bytes;
}

Diagnostic cannotWrite(const fs::path& path, const std::string& why) {
    return diagnose("file-E10", fmt::format("cannot write '{}': {}", path.string(), why));
}

TemporaryFile::TemporaryFile(const fs::path& target, NamedBy named)
    : target_(named == NamedBy::user ? resolved(target) : target), named_(named) {
    if (leadsNowhere(target, named)) {
        lastError_ = ELOOP;
        return;
    }
    // mkstemp ignores the user's file mode, so names are tried one by one; the process number keeps
    // concurrent runs apart.
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        // Not the full name of the target: with the suffix, it might exceed the longest file name.
        const std::string name =
            fmt::format(".glibra-{}-{}.tmp{}", ::getpid(), attempt, target_.extension().string());
        path_ = target_.parent_path() / name;
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) return;
        if (errno != EEXIST) break;
    }
    lastError_ = errno;
    path_.clear();
}

TemporaryFile::~TemporaryFile() {
    closeDescriptor();
    if (!path_.empty()) ::unlink(path_.c_str());
}

void TemporaryFile::closeDescriptor() {
    if (descriptor_ >= 0 && ::close(descriptor_) != 0) lastError_ = errno;
    descriptor_ = -1;
}

Diagnostic TemporaryFile::failure() const {
    return cannotWrite(target_, reason(lastError_));
}

Diagnostics TemporaryFile::commit() {
    if (path_.empty()) return {failure()};
    closeDescriptor();
    if (lastError_ != 0) return {failure()};
    Diagnostics problems = moveIntoPlace(path_, target_, named_);
    if (problems.empty()) path_.clear();
    return problems;
}

Diagnostics moveIntoPlace(const fs::path& from, const fs::path& target, NamedBy named) {
    if (mustStay(target, named)) {
        const auto bytes = readFile(from, {target.string(), {}}, std::numeric_limits<std::uint64_t>::max());
        if (!bytes) return {cannotWrite(target, bytes.diagnostics.front().text)};
        const int failed = writeOver(target, *bytes);
        if (failed == 0) ::unlink(from.c_str());
        if (failed == 0) return {};
        if (!mayNotWrite(failed)) return {cannotWrite(target, reason(failed))};
    }
    if (const Descriptor file(::open(from.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC)); file.number() >= 0) {
        keepOwner(target, named, file.number());
        base::keepAccess(AT_FDCWD, target, file.number());
    }
    if (::rename(from.c_str(), target.c_str()) != 0) return {cannotWrite(target, reason(errno))};
    return {};
}

void removeTemporaryFiles(const fs::path& folder, int process) {
    const std::string begin = fmt::format(".glibra-{}-", process);
    std::error_code failure;
    for (fs::directory_iterator each(folder.empty() ? "." : folder, failure), end; !failure && each != end;
         each.increment(failure))
        if (each->path().filename().string().starts_with(begin)) {
            std::error_code ignored;
            fs::remove(each->path(), ignored);
        }
}

void removeAbandonedFiles(const fs::path& folder) {
    constexpr std::time_t kAge = 60;
    constexpr std::string_view kBegin = ".glibra-";
    std::error_code failure;
    for (fs::directory_iterator each(folder.empty() ? "." : folder, failure), end; !failure && each != end;
         each.increment(failure)) {
        const std::string name = each->path().filename().string();
        if (!name.starts_with(kBegin)) continue;
        pid_t process = 0;
        const char* const last = name.data() + name.size();
        const auto [after, wrong] = std::from_chars(name.data() + kBegin.size(), last, process);
        int attempt = 0;
        if (wrong != std::errc{} || process <= 0 || after == last || *after != '-') continue;
        const auto [rest, alsoWrong] = std::from_chars(after + 1, last, attempt);
        if (alsoWrong != std::errc{} ||
            !std::string_view(rest, static_cast<std::size_t>(last - rest)).starts_with(".tmp"))
            continue;
        struct stat status{};
        if (::lstat(each->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode) ||
            status.st_uid != ::geteuid() || std::time(nullptr) - status.st_mtime < kAge ||
            ::kill(process, 0) == 0 || errno != ESRCH)
            continue;
        std::error_code ignored;
        fs::remove(each->path(), ignored);
    }
}

/// Writes a file that has no name until it is complete. Returns 0, an error number, or ENOTSUP where the
/// system has no such files.
static int writeUnnamed([[maybe_unused]] const fs::path& target,
                        [[maybe_unused]] std::span<const std::byte> bytes, [[maybe_unused]] NamedBy named) {
#ifdef O_TMPFILE
    const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.number() < 0) return ENOTSUP;  // the named file reports it
    const Descriptor file(::openat(folder.number(), ".", O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666));
    if (file.number() < 0) return ENOTSUP;
    if (const int failed = writeAll(file.number(), bytes); failed != 0) return failed;
    keepOwner(target, named, file.number());
    return base::nameFile(folder.number(), file.number(), target.filename());
#else
    return ENOTSUP;
#endif
}

Diagnostics writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes, NamedBy named) {
    struct stat status{};
    const bool exists =
        named == NamedBy::user ? ::stat(path.c_str(), &status) == 0 : ::lstat(path.c_str(), &status) == 0;
    if (leadsNowhere(path, named)) return {cannotWrite(path, reason(ELOOP))};
    if (exists && S_ISDIR(status.st_mode)) return {cannotWrite(path, "it is a folder")};
    if (exists && named == NamedBy::user && !S_ISREG(status.st_mode)) {
        const Descriptor device(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        const int failed = device.number() < 0 ? errno : writeAll(device.number(), bytes);
        if (failed != 0) return {cannotWrite(path, reason(failed))};
        return {};
    }
    const fs::path target = named == NamedBy::user ? resolved(path) : path;
    int written = mustStay(target, named) ? writeOver(target, bytes) : EACCES;
    if (mayNotWrite(written)) written = writeUnnamed(target, bytes, named);
    if (written == 0) return {};
    if (written != ENOTSUP) return {cannotWrite(path, reason(written))};
    TemporaryFile temporary(path, named);
    if (temporary.descriptor() < 0) return {temporary.failure()};
    if (const int failed = writeAll(temporary.descriptor(), bytes); failed != 0)
        return {cannotWrite(path, reason(failed))};
    return temporary.commit();
}

}  // namespace glibra::image
