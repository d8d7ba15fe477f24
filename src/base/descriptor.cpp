#include "base/descriptor.h"

#include <unistd.h>

#include <cerrno>
#include <utility>

namespace glibra::base {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

Descriptor::~Descriptor() {
    const int problem = errno;  // the caller still needs it
    if (number_ >= 0) ::close(number_);
    errno = problem;
}

int writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t put = ::write(file, bytes.data(), bytes.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(put));
    }
    return 0;
}

bool receiveAll(int pipe, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::read(pipe, bytes.data(), bytes.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

}  // namespace glibra::base
