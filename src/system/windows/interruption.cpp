#include "system/interruption.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <system_error>
#include <utility>

#include "system/child_process.h"
#include "system/windows/win.h"

namespace glibra::system {
namespace {

/// What the system calls on a thread of its own can only reach globals.
std::atomic<int> noted = 0;
std::atomic<const Waker*> waker = nullptr;

int signalOf(DWORD event) {
    if (event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT) return SIGINT;
    return event == CTRL_CLOSE_EVENT ? kHangup : SIGTERM;
}

/// When the window of the console is closed, at logout and at shutdown, Windows ends the process as soon as
/// this returns, or after some seconds. So it does not return, and the program ends itself meanwhile.
BOOL note(DWORD event) {
    noted = signalOf(event);
    if (const Waker* each = waker) each->wake();
    if (event != CTRL_C_EVENT && event != CTRL_BREAK_EVENT) ::Sleep(INFINITE);
    return TRUE;
}

BOOL WINAPI onEvent(DWORD event) {
    return note(event);
}

/// The second one is left to the system, which ends the program.
BOOL WINAPI onFirstEvent(DWORD event) {
    return noted == 0 ? note(event) : FALSE;
}

/// The status is the one that every console program has after Ctrl+C. Command processors know it: `cmd` asks
/// whether to end the batch file.
void endIfNoted() {
    if (noted == 0) return;
    std::fflush(nullptr);
    restoreConsole();
    ::ExitProcess(static_cast<UINT>(STATUS_CONTROL_C_EXIT));
}

}  // namespace

// What the program was started to ignore (CREATE_NEW_PROCESS_GROUP) does not come here.

struct Interruption::State {};

Interruption::Interruption() {
    noted = 0;
    ::SetConsoleCtrlHandler(onEvent, TRUE);
}

Interruption::~Interruption() {
    ::SetConsoleCtrlHandler(onEvent, FALSE);
}

int Interruption::signal() const {
    return noted;
}

void Interruption::obey() const {
    endIfNoted();
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
        return;  // these events end the program
    }
    waker = &state_->waker;
    ::SetConsoleCtrlHandler(onFirstEvent, TRUE);
}

EndingSignals::~EndingSignals() {
    if (!thread_.joinable()) return;
    ::SetConsoleCtrlHandler(onFirstEvent, FALSE);
    waker = nullptr;
    state_->waker.wake();
    thread_.join();
}

int EndingSignals::received() {
    return noted;
}

void EndingSignals::obey() {
    endIfNoted();
}

namespace {

struct SignalWords {
    int number;
    const char *reason, *text;
};
constexpr SignalWords kWords[] = {{kHangup, "the console was closed", "Hangup"},
                                  {SIGINT, "interrupted", "Interrupt"},
                                  {SIGILL, "illegal instruction", "Illegal instruction"},
                                  {SIGABRT, "abort", "Aborted"},
                                  {SIGFPE, "arithmetic error", "Arithmetic exception"},
                                  {kKilled, "killed, perhaps for lack of memory", "Killed"},
                                  {SIGSEGV, "segmentation fault", "Segmentation fault"},
                                  {kAlarm, "it took too long", "Alarm clock"},
                                  {SIGTERM, "terminated", "Terminated"},
                                  {kTimeLimit, "it used too much processor time", "CPU time limit exceeded"}};

const SignalWords* wordsFor(int signal) {
    const auto* const found = std::ranges::find(kWords, signal, &SignalWords::number);
    return found == std::end(kWords) ? nullptr : found;
}

}  // namespace

const char* signalReason(int signal) {
    const SignalWords* words = wordsFor(signal);
    return words == nullptr ? "see the exit status" : words->reason;
}

std::string signalText(int signal) {
    const SignalWords* words = wordsFor(signal);
    return words == nullptr ? "Unknown signal " + std::to_string(signal) : words->text;
}

}  // namespace glibra::system
