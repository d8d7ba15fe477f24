#include "base/standard_files.h"

#include <fcntl.h>
#include <unistd.h>

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

}  // namespace glibra::base
