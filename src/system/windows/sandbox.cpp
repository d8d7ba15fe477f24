#include "system/sandbox.h"

#include "system/windows/win.h"

namespace glibra::system {

std::string missingForSandbox() {
    return "Windows has no sandbox for processes that draw";
}

std::string enterSandbox(const Sandbox&, std::span<const File* const>) {
    return missingForSandbox();
}

void addGraphicsDevices(Sandbox&) {}

std::uint64_t bytesWrittenBy(const Process& process) {
    IO_COUNTERS counters{};
    return process && ::GetProcessIoCounters(winOf(process), &counters) ? counters.WriteTransferCount : 0;
}

std::uint64_t systemWorkFor(const Process& process) {
    FILETIME made{}, ended{}, system{}, user{};
    if (!process || !::GetProcessTimes(winOf(process), &made, &ended, &system, &user)) return 0;
    return std::uint64_t{system.dwHighDateTime} << 32U | system.dwLowDateTime;
}

}  // namespace glibra::system
