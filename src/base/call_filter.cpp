#include "base/call_filter.h"

#ifdef __linux__
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif
#include <fcntl.h>
#include <sched.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace glibra::base {

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__)) && defined(SYS_seccomp)

namespace {

#ifdef __x86_64__
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#else
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#endif

/// Calls that are let through with any arguments.
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
    SYS_pipe2,
    SYS_ftruncate,
    SYS_fallocate,
    SYS_fsync,
    SYS_fdatasync,
    SYS_fadvise64,
    SYS_flock,
    SYS_mkdirat,
    SYS_unlinkat,
    SYS_renameat,
    SYS_renameat2,
    SYS_umask,
    SYS_memfd_create,
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

class Program {
  public:
    Program() {
        load(offsetof(seccomp_data, arch));
        // Another architecture has other numbers.
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kArchitecture, 1, 0));
        end(SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
    }

    void allow(long call) {
        compare(static_cast<std::uint32_t>(call), 1);
        end(SECCOMP_RET_ALLOW);
    }
    /// Lets the call through if `argument & mask` is one of the values, or, with `except`, if it is none.
    void allowIf(long call, unsigned argument, std::uint32_t mask, const std::vector<std::uint32_t>& values,
                 bool except = false) {
        compare(static_cast<std::uint32_t>(call), static_cast<std::uint8_t>(3 + 2 * values.size()));
        // The lower half: what the kernel reads of these arguments has 32 bits.
        load(static_cast<std::uint32_t>(offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t)));
        code_.push_back(BPF_STMT(BPF_ALU | BPF_AND | BPF_K, mask));
        for (const std::uint32_t each : values) {
            compare(each, 1);
            end(except ? kRefused : SECCOMP_RET_ALLOW);
        }
        end(except ? SECCOMP_RET_ALLOW : kRefused);
    }
    /// Installs the filter on this thread. Returns 0 or an error number.
    int install() {
        end(SECCOMP_RET_ERRNO | ENOSYS);  // so that libraries fall back to an older call
        const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
        return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0 ? 0 : errno;
    }

  private:
    static constexpr std::uint32_t kRefused = SECCOMP_RET_ERRNO | EPERM;

    void load(std::size_t offset) {
        code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
    }
    /// Skips instructions unless the loaded value is this one.
    void compare(std::uint32_t value, std::uint8_t skipped) {
        code_.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skipped));
    }
    void end(std::uint32_t action) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, action)); }

    std::vector<sock_filter> code_;
};

}  // namespace

std::string missingCallFilter() {
    const std::uint32_t action = SECCOMP_RET_ERRNO;
    if (::syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0) return {};
    return std::string("the kernel has no seccomp filters: ") + std::strerror(errno);
}

std::string filterCalls() {
    constexpr std::uint32_t kWhole = 0xFFFF'FFFFU;
    constexpr std::uint32_t kNewNamespaces = CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC |
                                             CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;
    constexpr std::uint32_t kSetVma = 0x53564d41;  // names of memory, set by newer versions of glibc
    const auto self = static_cast<std::uint32_t>(::getpid());
    Program program;
    for (const long each : kAllowed) program.allow(each);
    // Threads, but no processes. clone3 has its flags in memory, where no filter sees them.
    program.allowIf(SYS_clone, 0, CLONE_THREAD | kNewNamespaces, {CLONE_THREAD});
    // Signals to this process only: abort() and raise() need them.
    program.allowIf(SYS_kill, 0, kWhole, {self});
    program.allowIf(SYS_tgkill, 0, kWhole, {self});
    program.allowIf(SYS_prlimit64, 0, kWhole, {0, self});
    program.allowIf(SYS_prctl, 0, kWhole, {PR_SET_NAME, PR_GET_NAME, kSetVma});
    // A terminal takes typed text by these two.
    program.allowIf(SYS_ioctl, 1, kWhole, {TIOCSTI, TIOCLINUX}, true);
    // An owner of a descriptor gets signals.
    program.allowIf(SYS_fcntl, 1, kWhole, {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_NOTIFY}, true);
    // Before its version 3, Landlock lets a file be emptied that is opened for reading.
    program.allowIf(SYS_openat, 2, O_TRUNC | O_ACCMODE, {O_TRUNC | O_RDONLY}, true);
#ifdef SYS_open
    program.allowIf(SYS_open, 1, O_TRUNC | O_ACCMODE, {O_TRUNC | O_RDONLY}, true);
#endif
    const int failed = program.install();
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

}  // namespace glibra::base
