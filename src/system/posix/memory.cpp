#include "system/memory.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include "system/posix/extras.h"

#ifndef MAP_NORESERVE
#define MAP_NORESERVE 0
#endif

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWith(int number) {
    throw std::system_error(number, std::generic_category());
}

}  // namespace

SharedMemory::SharedMemory(std::size_t size) {
    // Without a reservation: most callers fill a small part of what they ask for.
    const auto mapped = [&](int kind) {
        return ::mmap(nullptr, size, PROT_READ | PROT_WRITE, kind | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    };
    void* memory = mapped(MAP_SHARED);
    // A confined process (sandbox.h) can neither share memory nor fork: its calls run in a thread.
    if (memory == MAP_FAILED && errno == EPERM) memory = mapped(MAP_PRIVATE);
    if (memory != MAP_FAILED) bytes_ = {static_cast<std::byte*>(memory), size};
}

SharedMemory::~SharedMemory() {
    if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
}

MemoryFile::MemoryFile(const fs::path& near) : file_(openMemoryFile("glibra-picture")) {
    if (!file_ && errno == EPERM) {
        const fs::path folder = near.parent_path();
        file_ = File(openUnnamed(AT_FDCWD, folder.empty() ? "." : folder.c_str(), O_RDWR, S_IRUSR | S_IWUSR));
    }
    if (!file_) failWith(errno);
    path_ = pathOf(numberOf(file_));
}

MemoryFile::~MemoryFile() = default;

void MemoryFile::write(std::span<const std::byte> bytes) const {
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t put =
            ::pwrite(numberOf(file_), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
        if (put < 0 && errno != EINTR) failWith(errno);
        if (put > 0) done += static_cast<std::size_t>(put);
    }
}

std::vector<unsigned char> MemoryFile::content() const {
    struct stat status{};
    rlimit largest{};
    if (::fstat(numberOf(file_), &status) != 0) failWith(errno);
    if (::getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur != RLIM_INFINITY &&
        static_cast<rlim_t>(status.st_size) >= largest.rlim_cur)
        failWith(EFBIG);
    std::vector<unsigned char> bytes(static_cast<std::size_t>(status.st_size));
    for (std::size_t have = 0; have < bytes.size();) {
        const ssize_t got =
            ::pread(numberOf(file_), bytes.data() + have, bytes.size() - have, static_cast<off_t>(have));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) failWith(got < 0 ? errno : EIO);
        have += static_cast<std::size_t>(got);
    }
    return bytes;
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

void MemoryLimit::lower(std::uint64_t bytes) const {
    rlimit before{}, after{};
    const bool known = ::getrlimit(RLIMIT_DATA, &before) == 0;
    set(bytes);
    if (known && ::getrlimit(RLIMIT_DATA, &after) == 0 && before.rlim_cur < after.rlim_cur)
        ::setrlimit(RLIMIT_DATA, &before);
}

void MemoryLimit::setForever(std::uint64_t bytes) const {
    rlimit limit{};
    if (bytes == 0 || bytes >= RLIM_INFINITY - base_ || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_max = limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, base_ + bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
}

LiftedMemoryLimit::LiftedMemoryLimit() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == limit.rlim_max) return;
    before_ = limit.rlim_cur;
    taken_ = dataBytes();
    limit.rlim_cur = limit.rlim_max;
    ::setrlimit(RLIMIT_DATA, &limit);
}

LiftedMemoryLimit::~LiftedMemoryLimit() {
    rlimit limit{};
    if (before_ == 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, before_ + std::max(dataBytes(), taken_) - taken_);
    ::setrlimit(RLIMIT_DATA, &limit);
}

void limitProcessorTime(double seconds) {
    const auto whole = static_cast<rlim_t>(std::min(std::ceil(seconds), 1e9));
    const rlimit limit{whole, whole};
    ::setrlimit(RLIMIT_CPU, &limit);
}

void leaveNoCore() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

void failBeyondLargestFile() {
    ::signal(SIGXFSZ, SIG_IGN);
}

void endAfter(unsigned seconds) {
    ::alarm(seconds);
}

void stepBack() {
    constexpr int kNiceness = 10;
    ::setpriority(PRIO_PROCESS, 0, kNiceness);
}

}  // namespace glibra::system
