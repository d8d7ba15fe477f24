#include "base/standard_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace glibra::base {

bool openStandardFiles() noexcept {
    for (int number = 0; number <= 2; ++number) {
        if (::fcntl(number, F_GETFD) >= 0) continue;
        // The lowest free number is this one, since those below are open. The mode is the wrong one for the
        // stream on purpose: a picture for a closed standard output must be an error and not vanish.
        if (::open("/dev/null", number == 0 ? O_WRONLY : O_RDONLY) != number) return false;
    }
    return true;
}

std::string endStandardOutput() {
    errno = 0;
    if (std::fflush(stdout) != 0)
        return errno == 0 ? "it cannot be written" : std::generic_category().message(errno);
    return std::ferror(stdout) != 0 ? "a part of it could not be written" : "";
}

}  // namespace glibra::base
