#include "image/module/memory_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

[[noreturn]] void failWith(int number) {
    throw Failure{std::strerror(number)};
}

/// The limit holds for files in memory, too. A file that has reached it has lost what comes after.
bool isCutOff(rlim_t size) {
    rlimit largest{};
    return ::getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur != RLIM_INFINITY &&
           size >= largest.rlim_cur;
}

}  // namespace

MemoryFile::MemoryFile(const std::string& near) : descriptor_(::memfd_create("glibra-picture", MFD_CLOEXEC)) {
    if (descriptor_ < 0 && errno == EPERM) {
        const std::filesystem::path folder = std::filesystem::path(near).parent_path();
        descriptor_ =
            ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
    }
    if (descriptor_ < 0) failWith(errno);
}

MemoryFile::~MemoryFile() {
    ::close(descriptor_);
}

std::string MemoryFile::path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
}

std::vector<unsigned char> MemoryFile::content() const {
    struct stat status{};
    if (::fstat(descriptor_, &status) != 0) failWith(errno);
    if (isCutOff(static_cast<rlim_t>(status.st_size))) failWith(EFBIG);
    std::vector<unsigned char> bytes(static_cast<std::size_t>(status.st_size));
    std::size_t have = 0;
    while (have < bytes.size()) {
        const ssize_t got =
            ::pread(descriptor_, bytes.data() + have, bytes.size() - have, static_cast<off_t>(have));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) failWith(got < 0 ? errno : EIO);
        have += static_cast<std::size_t>(got);
    }
    return bytes;
}

}  // namespace glibra::module
