#include "system/posix/extras.h"

#include <fcntl.h>
#include <link.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>

#include "system/library.h"
#include "system/places.h"

namespace glibra::system {

bool openPipe(int (&ends)[2]) {
    return ::pipe2(ends, O_CLOEXEC) == 0;
}

bool openSockets(int (&ends)[2]) {
    return ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0;
}

bool openWaker(int& reading, int& writing) {
    reading = writing = ::eventfd(0, EFD_CLOEXEC);
    return reading >= 0;
}

int passingMode() {
    return O_PATH;
}

bool hasAccessList(int file) {
    return ::fgetxattr(file, "system.posix_acl_access", nullptr, 0) > 0;
}

int openUnnamed(int folder, const char* path, int access, mode_t mode) {
    return ::openat(folder, path, access | O_TMPFILE | O_CLOEXEC, mode);
}

int nameFile(int folder, int file, const std::filesystem::path& name) {
    const std::string open = pathOf(file);
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
}

int openMemoryFile(const char* what) {
    return ::memfd_create(what, MFD_CLOEXEC);
}

std::string pathOf(int file) {
    return "/proc/self/fd/" + std::to_string(file);
}

std::string pathOfThisProgram() {
    return "/proc/self/exe";
}

bool hasOneThread() {
    std::error_code problem;
    const std::filesystem::directory_iterator threads("/proc/self/task", problem);
    return !problem && std::distance(begin(threads), end(threads)) == 1;
}

void endWithParent() {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
}

void beFirstToEnd() {
    if (std::FILE* score = std::fopen("/proc/self/oom_score_adj", "w")) {
        std::fputs("1000", score);
        std::fclose(score);
    }
}

int descriptorOf([[maybe_unused]] pid_t process) {
#ifdef SYS_pidfd_open
    return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
#else
    return -1;
#endif
}

double processorSecondsOf(pid_t process) {
    clockid_t clock{};
    timespec used{};
    if (::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

std::uint64_t dataBytes() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    file >> total >> resident >> shared >> text >> library >> data;
    return file ? data * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

namespace fs = std::filesystem;

fs::path programFile() {
    std::error_code failure;
    return fs::read_symlink("/proc/self/exe", failure);
}

std::vector<std::string> ownWords() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    std::vector<std::string> words;
    for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
    return words;
}

std::string processorFact(std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        std::ifstream file("/proc/cpuinfo");
        for (std::string line; std::getline(file, line);) {
            const std::size_t colon = line.find(':');
            if (colon == std::string::npos || !line.starts_with(name)) continue;
            if (line.find_first_not_of(" \t", name.size()) != colon) continue;
            const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
            if (begin != std::string::npos) return line.substr(begin);
            break;
        }
    }
    return {};
}

std::uint64_t usableMemory() {
    std::uint64_t bytes = machineMemory();
    for (const char* each : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream file(each);
        std::uint64_t limit = 0;
        if (file >> limit) bytes = std::min(bytes, limit);  // the word "max" is not a number
    }
    return bytes;
}

bool isLibraryLoaded(std::initializer_list<std::string_view> words) {
    const auto isOne = [](dl_phdr_info* library, std::size_t, void* wanted) {
        const std::string_view path = library->dlpi_name;
        const auto& all = *static_cast<std::initializer_list<std::string_view>*>(wanted);
        return std::ranges::any_of(all, [&](std::string_view each) { return path.find(each) != path.npos; })
                   ? 1
                   : 0;
    };
    return dl_iterate_phdr(isOne, &words) != 0;
}

}  // namespace glibra::system
