#include "system/sandbox.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fstream>
#include <sstream>

#include "system/posix/extras.h"

// The list of calls is that of 64 bits.
#if defined(__x86_64__) || defined(__aarch64__)
#define GLIBRA_CALL_FILTER
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <initializer_list>
#endif

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

// Landlock: the files that a process can open (landlock(7)).

#if defined(SYS_landlock_create_ruleset)

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

/// Returns an empty text, or why there is no Landlock.
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

/// Confines this thread, and those that it will start, to the files of the sandbox. Returns an empty text, or
/// what failed. The process must have no_new_privs.
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

// A seccomp filter: the system calls that a process can make (seccomp(2)).

#ifdef GLIBRA_CALL_FILTER

/// Calls that are let through, with all arguments that the filter of refusals does not name.
constexpr long kAllowed[] = {
    // files, which Landlock confines
    SYS_read,
    SYS_write,
    SYS_readv,
    SYS_writev,
    SYS_pread64,
    SYS_pwrite64,
    SYS_preadv,
    SYS_pwritev,
    SYS_lseek,
    SYS_openat,
    SYS_close,
    SYS_close_range,
    SYS_fstat,
    SYS_newfstatat,
    SYS_statx,
    SYS_statfs,
    SYS_fstatfs,
    SYS_getdents64,
    SYS_readlinkat,
    SYS_faccessat,
    SYS_faccessat2,
    SYS_getcwd,
    SYS_dup,
    SYS_dup3,
    SYS_fcntl,
    SYS_ioctl,
    SYS_pipe2,
    SYS_ftruncate,
    SYS_fsync,
    SYS_fdatasync,
    SYS_fadvise64,
    SYS_flock,
    SYS_mkdirat,
    SYS_unlinkat,
    SYS_renameat,
    SYS_renameat2,
    SYS_umask,
    SYS_sendfile,
    SYS_copy_file_range,
    // waiting
    SYS_ppoll,
    SYS_pselect6,
    SYS_epoll_create1,
    SYS_epoll_ctl,
    SYS_epoll_pwait,
    SYS_eventfd2,
    SYS_nanosleep,
    SYS_clock_nanosleep,
    SYS_timerfd_create,
    SYS_timerfd_settime,
    SYS_futex,
    // memory; a driver's compiler makes memory executable
    SYS_brk,
    SYS_mmap,
    SYS_munmap,
    SYS_mprotect,
    SYS_mremap,
    SYS_madvise,
    SYS_mincore,
    SYS_msync,
    SYS_mlock,
    SYS_munlock,
    SYS_membarrier,
    // threads and the process itself
    SYS_exit,
    SYS_exit_group,
    SYS_set_tid_address,
    SYS_set_robust_list,
    SYS_gettid,
    SYS_getpid,
    SYS_getppid,
    SYS_getuid,
    SYS_geteuid,
    SYS_getgid,
    SYS_getegid,
    SYS_sched_yield,
    SYS_sched_getaffinity,
    SYS_sched_getparam,
    SYS_sched_getscheduler,
    SYS_sched_get_priority_max,
    SYS_sched_get_priority_min,
    SYS_getcpu,
    SYS_getrusage,
    SYS_getrlimit,
    SYS_times,
    SYS_uname,
    SYS_sysinfo,
    SYS_getrandom,
    SYS_clock_gettime,
    SYS_clock_getres,
    SYS_gettimeofday,
    SYS_rt_sigaction,
    SYS_rt_sigprocmask,
    SYS_rt_sigreturn,
    SYS_sigaltstack,
    SYS_rt_sigtimedwait,
    SYS_rt_sigsuspend,
    SYS_restart_syscall,
#ifdef SYS_rseq
    SYS_rseq,
#endif
#ifdef __x86_64__  // older forms, which other architectures do not have
    SYS_open,
    SYS_stat,
    SYS_lstat,
    SYS_access,
    SYS_readlink,
    SYS_mkdir,
    SYS_unlink,
    SYS_rename,
    SYS_creat,
    SYS_dup2,
    SYS_pipe,
    SYS_poll,
    SYS_select,
    SYS_epoll_wait,
    SYS_epoll_create,
    SYS_getdents,
    SYS_time,
    SYS_arch_prctl,
    SYS_pause,
#endif
};

/// Rules for system calls, and what happens to calls that no rule names.
class Filter {
  public:
    explicit Filter(std::uint32_t otherwise) : filter_(seccomp_init(otherwise)) {
        // Another architecture has other numbers.
        if (filter_ != nullptr)
            keep(seccomp_attr_set(filter_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
    }
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;
    ~Filter() { seccomp_release(filter_); }

    void add(std::uint32_t action, long call) {
        keep(seccomp_rule_add_array(filter_, action, number(call), 0, nullptr));
    }
    /// For calls with `argument & mask` equal to one of the values. What the kernel reads of these arguments
    /// has 32 bits.
    void add(std::uint32_t action, long call, unsigned argument, std::uint32_t mask,
             std::initializer_list<std::uint32_t> values) {
        for (const std::uint32_t each : values) {
            const scmp_arg_cmp comparison{argument, SCMP_CMP_MASKED_EQ, mask, each};
            keep(seccomp_rule_add_array(filter_, action, number(call), 1, &comparison));
        }
    }
    /// Holds for this thread from now on. Returns 0 or an error number.
    int install() {
        if (filter_ == nullptr) return ENOMEM;
        keep(seccomp_load(filter_));
        return failed_;
    }

  private:
    static int number(long call) { return static_cast<int>(call); }
    void keep(int result) {
        if (result < 0 && failed_ == 0) failed_ = -result;
    }

    scmp_filter_ctx filter_;
    int failed_ = 0;  ///< the first error number
};

/// Returns an empty text, or why there are no filters of system calls.
std::string missingCallFilter() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    if (::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0) return {};
    return std::string("the kernel has no seccomp filters: ") + std::strerror(errno);
}

/// Lets this process make only the system calls that reading files, drawing with a driver, threads and
/// writing files need; other calls fail with ENOSYS, and ioctl, fcntl and open with forbidden arguments with
/// EPERM. The process must have one thread and no_new_privs. Returns an empty text, or what failed.
std::string filterCalls() {
    if (std::string missing = missingCallFilter(); !missing.empty()) return missing;
    constexpr std::uint32_t kWhole = 0xFFFF'FFFFU;
    constexpr std::uint32_t kNewNamespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC |
                                             CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
    constexpr std::uint32_t kSetVma = 0x53564d41;  // names of memory, set by newer versions of glibc
    const auto self = static_cast<std::uint32_t>(::getpid());

    // A rule cannot say "none of these": arguments are refused by a filter of their own. The kernel asks
    // both.
    Filter refusals(SCMP_ACT_ALLOW);
    constexpr std::uint32_t kRefused = SCMP_ACT_ERRNO(EPERM);
    // A terminal takes typed text by these two.
    refusals.add(kRefused, SYS_ioctl, 1, kWhole, {TIOCSTI, TIOCLINUX});
    // No limit of memory counts what processes can share (nor what a file in memory has, SYS_memfd_create).
    refusals.add(kRefused, SYS_mmap, 3, MAP_SHARED | MAP_ANONYMOUS, {MAP_SHARED | MAP_ANONYMOUS});
    // An owner of a descriptor gets signals.
    refusals.add(kRefused, SYS_fcntl, 1, kWhole, {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_NOTIFY});
    // Before its version 3, Landlock lets a file be emptied that is opened for reading.
    refusals.add(kRefused, SYS_openat, 2, O_TRUNC | O_ACCMODE, {O_TRUNC | O_RDONLY});
#ifdef SYS_open
    refusals.add(kRefused, SYS_open, 1, O_TRUNC | O_ACCMODE, {O_TRUNC | O_RDONLY});
#endif

    Filter allowed(SCMP_ACT_ERRNO(ENOSYS));  // so that libraries fall back to an older call
    for (const long each : kAllowed) allowed.add(SCMP_ACT_ALLOW, each);
    // Threads, but no processes. clone3 has its flags in memory, where no filter sees them.
    allowed.add(SCMP_ACT_ALLOW, SYS_clone, 0, CLONE_THREAD | kNewNamespaces, {CLONE_THREAD});
    // Signals to this process only: abort() and raise() need them.
    allowed.add(SCMP_ACT_ALLOW, SYS_kill, 0, kWhole, {self});
    allowed.add(SCMP_ACT_ALLOW, SYS_tgkill, 0, kWhole, {self});
    allowed.add(SCMP_ACT_ALLOW, SYS_prlimit64, 0, kWhole, {0, self});
    allowed.add(SCMP_ACT_ALLOW, SYS_prctl, 0, kWhole, {PR_SET_NAME, PR_GET_NAME, kSetVma});

    int failed = refusals.install();
    if (failed == 0) failed = allowed.install();
    return failed == 0 ? std::string() : std::string("seccomp: ") + std::strerror(failed);
}

#else

std::string missingCallFilter() {
    return "this system has no seccomp filters (Linux on x86-64 and AArch64 has them)";
}
std::string filterCalls() {
    return missingCallFilter();
}

#endif

/// Closes all descriptors from 3 on but these. The parent's results file and other workers' pipes are among
/// them.
bool closeAllBut(std::vector<int> kept) {
#ifdef SYS_close_range
    std::sort(kept.begin(), kept.end());
    unsigned next = 3;
    const auto closeUpTo = [](unsigned first, unsigned last) {
        return first > last || ::syscall(SYS_close_range, first, last, 0) == 0;
    };
    for (const int each : kept) {
        const auto number = static_cast<unsigned>(each);
        if (number < next) continue;
        if (!closeUpTo(next, number - 1)) return false;
        next = number + 1;
    }
    return closeUpTo(next, UINT_MAX);
#else
    return kept.empty();
#endif
}

/// What drivers and the C library read and use, on this and other systems.
void addSystem(Sandbox& sandbox) {
    std::istringstream readable(
        "/usr/lib /usr/lib64 /usr/lib32 /lib /lib64 /usr/local/lib /usr/share/glvnd "
        "/usr/share/drirc.d /usr/share/libdrm /usr/share/egl /usr/share/nvidia /usr/share/vulkan "
        "/usr/share/zoneinfo /etc/glvnd /etc/vulkan /etc/drirc /etc/ld.so.cache /etc/ld.so.conf "
        "/etc/ld.so.conf.d /etc/ld.so.preload /etc/localtime /nix/store /run/opengl-driver "
        "/sys/devices /sys/dev/char /sys/bus/pci/devices /sys/class/drm /proc/cpuinfo "
        "/proc/meminfo /proc/stat /proc/sys/vm/overcommit_memory /proc/driver/nvidia "
        "/proc/modules /dev/urandom /dev/random ");
    for (std::string each; readable >> each;) sandbox.readable.emplace_back(fs::path(each));
    // Not /dev/zero: mapped, it is memory that no limit counts.
    sandbox.devices.emplace_back("/dev/null");
}

/// Limits the size of each file that is written, for good. Returns false if that fails.
bool limitFiles() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    limit.rlim_max = limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, kLargestWritten);
    return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

/// Gives up the rights of the superuser but those to files of others, which a check of modes would refuse:
/// with the right to raise limits (CAP_SYS_RESOURCE), no limit of memory would hold. Returns false if that
/// fails.
bool giveUpRights() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> rights{};
    if (::syscall(SYS_capget, &header, rights.data()) != 0) return false;
    constexpr std::uint32_t kKept = (1U << CAP_DAC_OVERRIDE) | (1U << CAP_DAC_READ_SEARCH);
    bool isChanged = false;
    for (std::size_t i = 0; i < rights.size(); ++i) {
        const std::uint32_t kept = i == 0 ? kKept : 0;
        const __user_cap_data_struct before = rights[i];
        rights[i].effective &= kept;
        rights[i].permitted &= kept;
        rights[i].inheritable = 0;
        isChanged = isChanged || before.effective != rights[i].effective ||
                    before.permitted != rights[i].permitted || before.inheritable != 0;
    }
    return !isChanged || ::syscall(SYS_capset, &header, rights.data()) == 0;
}

}  // namespace

std::string missingForSandbox() {
    std::string missing = missingLandlock();
    if (const std::string other = missingCallFilter(); !other.empty())
        missing += (missing.empty() ? "" : "; ") + other;
    return missing;
}

std::string enterSandbox(const Sandbox& sandbox, std::span<const File* const> files) {
    std::vector<int> kept;
    for (const File* each : files) kept.push_back(numberOf(*each));
    const auto failed = [](const char* what) { return std::string(what) + ": " + std::strerror(errno); };
    if (!closeAllBut(std::move(kept))) return failed("close_range");
    const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (null < 0) return failed("/dev/null");
    for (const int each : {0, 1, 2})
        if (!(each == 1 && sandbox.standardOutput) && ::dup2(null, each) < 0) return failed("/dev/null");
    ::close(null);
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return failed("no_new_privs");
    if (!limitFiles()) return failed("setrlimit");
    if (!giveUpRights()) return failed("capset");
    Sandbox whole = sandbox;
    addSystem(whole);
    if (std::string problem = confineFiles(whole); !problem.empty()) return problem;
    return filterCalls();
}

void addGraphicsDevices(Sandbox& sandbox) {
    for (const char* each :
         {"/dev/dri", "/dev/nvidiactl", "/dev/nvidia-modeset", "/dev/nvidia-uvm", "/dev/dxg"})
        sandbox.devices.emplace_back(each);
    constexpr int kMostDevices = 16;
    for (int i = 0; i < kMostDevices; ++i)
        sandbox.devices.emplace_back(fs::path("/dev/nvidia" + std::to_string(i)));
}

std::uint64_t bytesWrittenBy(const Process& process) {
    std::ifstream file("/proc/" + std::to_string(process.number()) + "/io");
    std::uint64_t written = 0, value = 0;
    for (std::string key; file >> key >> value;)
        if (key == "wchar:" || key == "write_bytes:") written = std::max(written, value);
    return written;
}

std::uint64_t systemWorkFor(const Process& process) {
    constexpr int kBefore = 12;  // fields between the name and this one (proc(5))
    std::ifstream file("/proc/" + std::to_string(process.number()) + "/stat");
    std::string field;
    std::getline(file, field, ')');
    for (int i = 0; i < kBefore; ++i) file >> field;
    std::uint64_t ticks = 0;
    file >> ticks;
    return ticks;
}

}  // namespace glibra::system
