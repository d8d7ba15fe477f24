#include "system/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>

#include "system/file.h"

namespace glibra::system {
namespace {

int numberOf(Standard stream) {
    return static_cast<int>(stream);
}
static_assert(static_cast<int>(Standard::input) == STDIN_FILENO &&
              static_cast<int>(Standard::output) == STDOUT_FILENO &&
              static_cast<int>(Standard::error) == STDERR_FILENO);

}  // namespace

bool openStandardFiles() noexcept {
    for (int number = 0; number <= 2; ++number) {
        if (::fcntl(number, F_GETFD) >= 0) continue;
        // The lowest free number is this one, since those below are open. The mode is the wrong one for the
        // stream on purpose: a picture for a closed standard output must be an error and not vanish.
        if (::open("/dev/null", number == 0 ? O_WRONLY : O_RDONLY) != number) return false;
    }
    return true;
}

bool isTerminal(Standard stream) {
    return ::isatty(numberOf(stream)) == 1;
}

std::size_t terminalColumns() {
    constexpr std::size_t kUsual = 80;
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kUsual;
}

bool isSameFile(Standard first, Standard second) {
    struct stat a{}, b{};
    return ::fstat(numberOf(first), &a) == 0 && ::fstat(numberOf(second), &b) == 0 && a.st_dev == b.st_dev &&
           a.st_ino == b.st_ino;
}

int readInput(std::span<char> bytes, std::size_t& count) {
    ssize_t got = -1;
    do got = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    while (got < 0 && errno == EINTR);
    count = got > 0 ? static_cast<std::size_t>(got) : 0;
    return got < 0 ? errno : 0;
}

std::optional<bool> isInputReady(int milliseconds) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, milliseconds);
    if (ready < 0 && errno == EINTR) return std::nullopt;
    return ready != 0;
}

int writeOutput(std::string_view text) {
    while (!text.empty()) {
        const ssize_t put = ::write(STDOUT_FILENO, text.data(), text.size());
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(put));
    }
    return 0;
}

}  // namespace glibra::system
