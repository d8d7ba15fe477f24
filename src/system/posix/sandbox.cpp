// POSIX has nothing that confines a process. src/system/linux/sandbox.cpp replaces this file.

#include "system/sandbox.h"

namespace glibra::system {

std::string missingForSandbox() {
    return "this system has no Landlock (Linux 5.13 or later has it); this system has no seccomp filters "
           "(Linux on "
           "x86-64 and AArch64 has them)";
}

std::string enterSandbox(const Sandbox&, std::span<const File* const>) {
    return missingForSandbox();
}

void addGraphicsDevices(Sandbox&) {}

std::uint64_t bytesWrittenBy(const Process&) {
    return 0;
}

std::uint64_t systemWorkFor(const Process&) {
    return 0;
}

}  // namespace glibra::system
