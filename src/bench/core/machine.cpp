#include "bench/core/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <string_view>
#include <thread>

namespace glibra::bench {
namespace {

/// The value of the first line of /proc/cpuinfo that starts with one of the names under which kernels list
/// the processor's model.
std::string processorModel() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        for (const std::string_view name : {"model name", "Model", "CPU implementer"}) {
            const std::size_t colon = line.find(": ");
            if (line.starts_with(name) && colon != std::string::npos) return line.substr(colon + 2);
        }
    return {};
}

std::string compilerVersion() {
#if defined(__clang__)
    return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return {};
#endif
}

}  // namespace

Machine describeMachine() {
    Machine machine;
    machine.processor = processorModel();
    machine.cores = static_cast<int>(std::thread::hardware_concurrency());
    machine.memory =
        static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
    utsname system{};
    if (::uname(&system) == 0)
        machine.system = fmt::format("{} {} {}", system.sysname, system.release, system.machine);
    machine.compiler = compilerVersion();
    return machine;
}

}  // namespace glibra::bench
