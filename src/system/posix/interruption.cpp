#include "system/interruption.h"

#include <signal.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "system/child_process.h"

namespace glibra::system {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// A signal handler can only reach globals.
volatile std::sig_atomic_t noted = 0;
const Waker* waker = nullptr;

void onSignal(int signal) {
    const int before = errno;
    noted = signal;
    if (waker != nullptr) waker->wake();
    errno = before;
}

/// What the program was started to ignore, as by nohup, stays so.
void handle(void (*handler)(int), int flags) {
    for (const int each : kSignals) {
        struct sigaction action{};
        action.sa_handler = handler;
        action.sa_flags = flags;
        sigemptyset(&action.sa_mask);
        struct sigaction before{};
        if (::sigaction(each, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
            ::sigaction(each, &action, nullptr);
    }
}

void endBy(int signal) {
    if (signal == 0) return;
    ::signal(signal, SIG_DFL);
    ::raise(signal);
}

}  // namespace

struct Interruption::State {
    std::array<struct sigaction, kSignals.size()> before{};
};

Interruption::Interruption() : before_(std::make_unique<State>()) {
    noted = 0;
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], nullptr, &before_->before[i]);
    handle(onSignal, 0);
}

Interruption::~Interruption() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_->before[i], nullptr);
}

int Interruption::signal() const {
    return noted;
}

void Interruption::obey() const {
    endBy(noted);
}

struct EndingSignals::State {
    Waker waker;
};

EndingSignals::EndingSignals(std::function<void()> wake)
    : wake_(std::move(wake)), state_(std::make_unique<State>()) {
    noted = 0;
    if (!state_->waker) return;
    try {
        thread_ = std::thread([this] {
            state_->waker.wait();
            wake_();
        });
    } catch (const std::system_error&) {
        return;  // signals end the program
    }
    waker = &state_->waker;
    handle(onSignal, SA_RESTART | static_cast<int>(SA_RESETHAND));
}

EndingSignals::~EndingSignals() {
    if (!thread_.joinable()) return;
    handle(SIG_DFL, 0);
    state_->waker.wake();
    thread_.join();
    waker = nullptr;
}

int EndingSignals::received() {
    return noted;
}

void EndingSignals::obey() {
    endBy(noted);
}

const char* signalReason(int signal) {
    static constexpr std::pair<int, const char*> kReasons[] = {
        {SIGABRT, "abort"},
        {SIGBUS, "bus error"},
        {SIGFPE, "arithmetic error"},
        {SIGKILL, "killed, perhaps for lack of memory"},
        {SIGSEGV, "segmentation fault"}};
    for (const auto& [number, reason] : kReasons)
        if (number == signal) return reason;
    return "see signal(7)";
}

std::string signalText(int signal) {
    return ::strsignal(signal);
}

}  // namespace glibra::system
