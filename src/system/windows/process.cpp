#include "system/process.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <utility>

#include "system/windows/win.h"

#include <psapi.h>

namespace glibra::system {
namespace {

/// The signal that another system would have ended a process with; 0: it has ended by itself.
int signalOf(DWORD status) {
    static constexpr std::pair<DWORD, int> kSignals[] = {
        {EXCEPTION_ACCESS_VIOLATION, SIGSEGV},
        {EXCEPTION_IN_PAGE_ERROR, SIGSEGV},
        {EXCEPTION_GUARD_PAGE, SIGSEGV},
        {EXCEPTION_STACK_OVERFLOW, SIGSEGV},
        {EXCEPTION_DATATYPE_MISALIGNMENT, SIGSEGV},
        {EXCEPTION_ARRAY_BOUNDS_EXCEEDED, SIGSEGV},
        {EXCEPTION_ILLEGAL_INSTRUCTION, SIGILL},
        {EXCEPTION_PRIV_INSTRUCTION, SIGILL},
        {EXCEPTION_FLT_DENORMAL_OPERAND, SIGFPE},
        {EXCEPTION_FLT_DIVIDE_BY_ZERO, SIGFPE},
        {EXCEPTION_FLT_INEXACT_RESULT, SIGFPE},
        {EXCEPTION_FLT_INVALID_OPERATION, SIGFPE},
        {EXCEPTION_FLT_OVERFLOW, SIGFPE},
        {EXCEPTION_FLT_STACK_CHECK, SIGFPE},
        {EXCEPTION_FLT_UNDERFLOW, SIGFPE},
        {EXCEPTION_INT_DIVIDE_BY_ZERO, SIGFPE},
        {EXCEPTION_INT_OVERFLOW, SIGFPE},
        {0xC0000017, kKilled},  // no memory
        {0xC0000374, SIGABRT},  // a damaged heap
        {0xC0000409, SIGABRT},  // __fastfail(), as by abort() of the universal C runtime
        {0x40000015, SIGABRT},  // a fatal exit
        {0xE06D7363, SIGABRT},  // an exception of C++ that nobody has caught
        {0x20474343, SIGABRT},  // the same of GCC
        {0xC000013A, SIGINT}};  // Ctrl+C
    const auto* const found = std::ranges::find(kSignals, status, &std::pair<DWORD, int>::first);
    if (found != std::end(kSignals)) return found->second;
    constexpr DWORD kNumber = 0xFF;
    return status > statusOfSignal(0) && status <= statusOfSignal(kNumber)
               ? static_cast<int>(status & kNumber)
               : 0;
}

/// Windows tells no signals, but the exit status is that of the exception. 3, the status of abort() in the
/// older C runtime, is also one of ours: leaveNoCore() lets abort() end otherwise.
End endOf(HANDLE process) {
    DWORD status = 0;
    End end;
    if (!::GetExitCodeProcess(process, &status)) return end;
    end.signal = signalOf(status);
    end.wasTimeLimit = end.signal == kTimeLimit;
    end.status = end.signal == 0 ? static_cast<int>(status) : 0;
    PROCESS_MEMORY_COUNTERS memory{};
    // What a limit of memory counts: that the process has asked for, wherever it is.
    if (::GetProcessMemoryInfo(process, &memory, sizeof memory)) end.peakMemory = memory.PeakPagefileUsage;
    return end;
}

double secondsOf(const FILETIME& time) {
    constexpr double kSeconds = 1e-7;
    return kSeconds * (4294967296. * time.dwHighDateTime + time.dwLowDateTime);
}

}  // namespace

Process::~Process() {
    if (handle_ != kNoHandle) std::unique_ptr<Started>(reinterpret_cast<Started*>(handle_));
}

int Process::number() const {
    return handle_ == kNoHandle ? -1 : static_cast<int>(::GetProcessId(winOf(*this)));
}

End waitFor(Process& process) {
    return *waitFor(process, 0);
}

std::optional<End> waitFor(Process& process, double seconds) {
    if (!process) return End{};
    constexpr double kLongest = 4e9;
    const DWORD wait =
        seconds > 0 ? static_cast<DWORD>(std::min(std::ceil(seconds * 1000), kLongest)) : INFINITE;
    if (::WaitForSingleObject(winOf(process), wait) == WAIT_TIMEOUT) return std::nullopt;
    const End end = endOf(winOf(process));
    process = Process();
    return end;
}

void kill(const Process& process) {
    if (!process) return;
    const Started& started = *reinterpret_cast<const Started*>(process.handle());
    ::TerminateJobObject(winOf(started.job), statusOfSignal(kKilled));
    ::TerminateProcess(winOf(started.process), statusOfSignal(kKilled));
}

int ownNumber() {
    return repeatsParent() ? parentNumber() : static_cast<int>(::GetCurrentProcessId());
}

bool isRunning(long long number) {
    if (number <= 0 || !std::in_range<DWORD>(number)) return false;
    const File process = ownOf(
        ::OpenProcess(SYNCHRONIZE | PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(number)));
    if (!process) return ::GetLastError() == ERROR_ACCESS_DENIED;
    // The system also finds a process by the three numbers that follow its own.
    return ::GetProcessId(winOf(process)) == static_cast<DWORD>(number) &&
           ::WaitForSingleObject(winOf(process), 0) == WAIT_TIMEOUT;
}

/// Only where processes are copied has this a meaning.
bool hasOneThread() {
    return false;
}

double processorSecondsOf(const Process& process) {
    FILETIME made{}, ended{}, system{}, user{};
    if (!process || !::GetProcessTimes(winOf(process), &made, &ended, &system, &user)) return 0;
    return secondsOf(system) + secondsOf(user);
}

Process runInCopy(const std::function<void()>&) {
    errno = ENOSYS;
    return {};
}

void endBySignals() {}

/// A process is put into the job of its parent when it is started.
void endWithParent() {}

void onCopy(void (*)()) {}

}  // namespace glibra::system
