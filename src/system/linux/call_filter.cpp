#include "system/linux/call_filter.h"

// The list of calls is that of 64 bits.
#if defined(__x86_64__) || defined(__aarch64__)
#define GLIBRA_CALL_FILTER
#include <fcntl.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#endif

namespace glibra::system {

#ifdef GLIBRA_CALL_FILTER

namespace {

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

}  // namespace

std::string missingCallFilter() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    if (::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0) return {};
    return std::string("the kernel has no seccomp filters: ") + std::strerror(errno);
}

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

}  // namespace glibra::system
