#include "base/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace glibra::base {
namespace {

std::uint64_t pageBytes() {
    return static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PAGESIZE)));
}

/// The private writable memory of this process; 0 if the system does not tell.
std::uint64_t dataBytes() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    file >> total >> resident >> shared >> text >> library >> data;
    return file ? data * pageBytes() : 0;
}

/// The memory of the machine, or of this process's control group.
std::uint64_t machineBytes() {
    std::uint64_t bytes = static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES))) * pageBytes();
    for (const char* each : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream file(each);
        std::uint64_t limit = 0;
        if (file >> limit) bytes = std::min(bytes, limit);  // the word "max" is not a number
    }
    return bytes;
}

}  // namespace

std::uint64_t memoryShare(int jobs, std::size_t pieces) {
    const auto workers = std::min<std::uint64_t>(static_cast<std::uint64_t>(std::max(1, jobs)), pieces);
    return std::max(kLeastShare, machineBytes() / 2 / std::max<std::uint64_t>(1, workers));
}

MemoryLimit::MemoryLimit() : base_(dataBytes()) {}

void MemoryLimit::set(std::uint64_t bytes) const {
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = limit.rlim_max;
    // Only the soft limit changes, so that the next call can raise it again.
    if (bytes > 0 && bytes < RLIM_INFINITY - base_)
        limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, base_ + bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
}

void MemoryLimit::setForever(std::uint64_t bytes) const {
    rlimit limit{};
    if (bytes == 0 || bytes >= RLIM_INFINITY - base_ || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_max = limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, base_ + bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace glibra::base
