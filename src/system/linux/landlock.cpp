#include "system/linux/landlock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

#include "system/posix/extras.h"
#include "system/sandbox.h"

namespace glibra::system {

namespace fs = std::filesystem;

#if defined(SYS_landlock_create_ruleset)

namespace {

// From <linux/landlock.h>, whose older versions lack some of it. The numbers in comments are those of the
// versions of Landlock that brought a right.
constexpr std::uint64_t kExecute = 1U << 0, kWriteFile = 1U << 1, kReadFile = 1U << 2, kReadFolder = 1U << 3,
                        kRemoveFile = 1U << 5, kMakeFolder = 1U << 7, kMakeFile = 1U << 8;
constexpr std::uint64_t kFirstFileRights = (1U << 13) - 1;
constexpr std::uint64_t kRefer = 1U << 13;                             // 2: names in another folder
constexpr std::uint64_t kTruncate = 1U << 14;                          // 3
constexpr std::uint64_t kControlDevice = 1U << 15;                     // 5
constexpr std::uint64_t kBind = 1U << 0, kConnect = 1U << 1;           // 4
constexpr std::uint64_t kAbstractSocket = 1U << 0, kSignal = 1U << 1;  // 6
constexpr std::uint64_t kOfFiles = kExecute | kWriteFile | kReadFile | kTruncate | kControlDevice;

struct Attributes {
    std::uint64_t files, network, scopes;
};
struct [[gnu::packed]] PathRule {
    std::uint64_t rights;
    std::int32_t folder;
};
constexpr unsigned kAskVersion = 1U << 0;
constexpr int kPathRuleType = 1;

long version() {
    return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, kAskVersion);
}

/// Opens a path below its root one part after the other, so that nobody can put a link in between.
File openReach(const Reach& reach) {
    if (reach.root.empty())
        return File(::open(reach.path.empty() ? "." : reach.path.c_str(), O_PATH | O_CLOEXEC));
    File file(::open(reach.root.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    for (const fs::path& part : reach.path) {
        if (!file) break;
        if (part.empty() || part == ".") continue;
        if (part == ".." || part.is_absolute()) {
            errno = ENOENT;
            return {};
        }
        // With O_PATH, a link is opened itself.
        file = File(::openat(numberOf(file), part.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
        struct stat status{};
        if (file && (::fstat(numberOf(file), &status) != 0 || S_ISLNK(status.st_mode))) {
            errno = ENOENT;
            return {};
        }
    }
    return file;
}

/// Returns 0 or an error number. A path that does not exist is no error.
int allow(int rules, const Reach& reach, std::uint64_t rights) {
    const File file = openReach(reach);
    if (!file) return errno == ENOENT || errno == ENOTDIR || errno == EACCES ? 0 : errno;
    struct stat status{};
    if (::fstat(numberOf(file), &status) != 0) return errno;
    PathRule rule{S_ISDIR(status.st_mode) ? rights : rights & kOfFiles, numberOf(file)};
    return ::syscall(SYS_landlock_add_rule, rules, kPathRuleType, &rule, 0) == 0 ? 0 : errno;
}

}  // namespace

std::string missingLandlock() {
    if (version() >= 1) return {};
    switch (errno) {
        case ENOSYS:
            return "the kernel has no Landlock (Linux 5.13 or later has it)";
        case EOPNOTSUPP:
            return "Landlock is switched off; add it to the kernel's parameter lsm=";
        default:
            return std::string("Landlock cannot be used: ") + std::strerror(errno);
    }
}

std::string confineFiles(const Sandbox& sandbox) {
    const long known = version();
    Attributes handled{kFirstFileRights, 0, 0};
    if (known >= 2) handled.files |= kRefer;
    if (known >= 3) handled.files |= kTruncate;
    if (known >= 5) handled.files |= kControlDevice;
    if (known >= 4) handled.network = kBind | kConnect;
    if (known >= 6) handled.scopes = kAbstractSocket | kSignal;
    const std::size_t size = known >= 6 ? sizeof handled : known >= 4 ? 16 : 8;
    const auto failed = [](const char* what, int number) {
        return std::string("Landlock: ") + what + ": " + std::strerror(number);
    };
    const auto rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, size, 0));
    if (rules < 0) return failed("no set of rules", errno);
    const std::uint64_t reading = kReadFile | kReadFolder;
    const std::uint64_t writing = reading | kWriteFile | kTruncate | kMakeFile | kMakeFolder | kRemoveFile;
    const std::uint64_t device = reading | kWriteFile | kControlDevice;
    int problem = 0;
    const auto allowAll = [&](const std::vector<Reach>& paths, std::uint64_t rights) {
        for (const Reach& each : paths)
            if (problem == 0) problem = allow(rules, each, rights & handled.files);
    };
    allowAll(sandbox.readable, reading);
    allowAll(sandbox.writable, writing);
    allowAll(sandbox.listable, kReadFolder);
    allowAll(sandbox.devices, device);
    if (problem == 0 && ::syscall(SYS_landlock_restrict_self, rules, 0) != 0) problem = errno;
    ::close(rules);
    return problem == 0 ? std::string() : failed("a rule is refused", problem);
}

#else

std::string missingLandlock() {
    return "this system has no Landlock (Linux 5.13 or later has it)";
}
std::string confineFiles(const Sandbox&) {
    return missingLandlock();
}

#endif

}  // namespace glibra::system
