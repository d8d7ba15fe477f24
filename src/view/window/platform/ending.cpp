#include "view/window/platform/ending.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <system_error>
#include <utility>

namespace glibra::view {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// What a handler of signals may use.
volatile std::sig_atomic_t receivedSignal = 0;
int wakingEvent = -1;

void writeEvent() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(wakingEvent, &one, sizeof one);
}

void onSignal(int signal) {
    const int before = errno;
    receivedSignal = signal;
    writeEvent();
    errno = before;
}

void handle(void (*handler)(int), int flags) {
    for (const int each : kSignals) {
        struct sigaction action{};
        action.sa_handler = handler;
        action.sa_flags = flags;
        sigemptyset(&action.sa_mask);
        struct sigaction before{};
        // What the program was started to ignore, as by nohup, stays so.
        if (::sigaction(each, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(each, &action, nullptr);
    }
}

}  // namespace

EndingSignals::EndingSignals(std::function<void()> wake) : wake_(std::move(wake)) {
    receivedSignal = 0;
    wakingEvent = ::eventfd(0, EFD_CLOEXEC);
    if (wakingEvent < 0) return;
    try {
        thread_ = std::thread([this] {
            std::uint64_t count = 0;
            while (::read(wakingEvent, &count, sizeof count) < 0 && errno == EINTR) {
            }
            wake_();
        });
    } catch (const std::system_error&) {
        return;  // signals end the program
    }
    handle(onSignal, SA_RESTART | static_cast<int>(SA_RESETHAND));
}

EndingSignals::~EndingSignals() {
    if (thread_.joinable()) {
        handle(SIG_DFL, 0);
        writeEvent();
        thread_.join();
    }
    if (wakingEvent >= 0) ::close(std::exchange(wakingEvent, -1));
}

int EndingSignals::received() {
    return receivedSignal;
}

}  // namespace glibra::view
