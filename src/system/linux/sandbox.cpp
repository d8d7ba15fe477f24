#include "system/sandbox.h"

#include <fcntl.h>
#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "system/linux/call_filter.h"
#include "system/linux/landlock.h"
#include "system/posix/extras.h"

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

/// Closes all descriptors from 3 on but these. The parent's results file and other workers' pipes are among
/// them.
bool closeAllBut(std::vector<int> kept) {
#ifdef SYS_close_range
    std::sort(kept.begin(), kept.end());
    unsigned next = 3;
    const auto closeUpTo = [](unsigned first, unsigned last) {
        return first > last || ::syscall(SYS_close_range, first, last, 0) == 0;
    };
    for (const int each : kept) {
        const auto number = static_cast<unsigned>(each);
        if (number < next) continue;
        if (!closeUpTo(next, number - 1)) return false;
        next = number + 1;
    }
    return closeUpTo(next, UINT_MAX);
#else
    return kept.empty();
#endif
}

/// What drivers and the C library read and use, on this and other systems.
void addSystem(Sandbox& sandbox) {
    std::istringstream readable(
        "/usr/lib /usr/lib64 /usr/lib32 /lib /lib64 /usr/local/lib /usr/share/glvnd "
        "/usr/share/drirc.d /usr/share/libdrm /usr/share/egl /usr/share/nvidia /usr/share/vulkan "
        "/usr/share/zoneinfo /etc/glvnd /etc/vulkan /etc/drirc /etc/ld.so.cache /etc/ld.so.conf "
        "/etc/ld.so.conf.d /etc/ld.so.preload /etc/localtime /nix/store /run/opengl-driver "
        "/sys/devices /sys/dev/char /sys/bus/pci/devices /sys/class/drm /proc/cpuinfo "
        "/proc/meminfo /proc/stat /proc/sys/vm/overcommit_memory /proc/driver/nvidia "
        "/proc/modules /dev/urandom /dev/random ");
    for (std::string each; readable >> each;) sandbox.readable.emplace_back(fs::path(each));
    // Not /dev/zero: mapped, it is memory that no limit counts.
    sandbox.devices.emplace_back("/dev/null");
}

/// Limits the size of each file that is written, for good. Returns false if that fails.
bool limitFiles() {
    rlimit limit{};
    if (::getrlimit(RLIMIT_FSIZE, &limit) != 0) return false;
    limit.rlim_max = limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, kLargestWritten);
    return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

/// Gives up the rights of the superuser but those to files of others, which a check of modes would refuse:
/// with the right to raise limits (CAP_SYS_RESOURCE), no limit of memory would hold. Returns false if that
/// fails.
bool giveUpRights() {
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> rights{};
    if (::syscall(SYS_capget, &header, rights.data()) != 0) return false;
    constexpr std::uint32_t kKept = (1U << CAP_DAC_OVERRIDE) | (1U << CAP_DAC_READ_SEARCH);
    bool isChanged = false;
    for (std::size_t i = 0; i < rights.size(); ++i) {
        const std::uint32_t kept = i == 0 ? kKept : 0;
        const __user_cap_data_struct before = rights[i];
        rights[i].effective &= kept;
        rights[i].permitted &= kept;
        rights[i].inheritable = 0;
        isChanged = isChanged || before.effective != rights[i].effective ||
                    before.permitted != rights[i].permitted || before.inheritable != 0;
    }
    return !isChanged || ::syscall(SYS_capset, &header, rights.data()) == 0;
}

}  // namespace

std::string missingForSandbox() {
    std::string missing = missingLandlock();
    if (const std::string other = missingCallFilter(); !other.empty())
        missing += (missing.empty() ? "" : "; ") + other;
    return missing;
}

std::string enterSandbox(const Sandbox& sandbox, std::span<const File* const> files) {
    std::vector<int> kept;
    for (const File* each : files) kept.push_back(numberOf(*each));
    const auto failed = [](const char* what) { return std::string(what) + ": " + std::strerror(errno); };
    if (!closeAllBut(std::move(kept))) return failed("close_range");
    const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (null < 0) return failed("/dev/null");
    for (const int each : {0, 1, 2})
        if (!(each == 1 && sandbox.standardOutput) && ::dup2(null, each) < 0) return failed("/dev/null");
    ::close(null);
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return failed("no_new_privs");
    if (!limitFiles()) return failed("setrlimit");
    if (!giveUpRights()) return failed("capset");
    Sandbox whole = sandbox;
    addSystem(whole);
    if (std::string problem = confineFiles(whole); !problem.empty()) return problem;
    return filterCalls();
}

void addGraphicsDevices(Sandbox& sandbox) {
    for (const char* each :
         {"/dev/dri", "/dev/nvidiactl", "/dev/nvidia-modeset", "/dev/nvidia-uvm", "/dev/dxg"})
        sandbox.devices.emplace_back(each);
    constexpr int kMostDevices = 16;
    for (int i = 0; i < kMostDevices; ++i)
        sandbox.devices.emplace_back(fs::path("/dev/nvidia" + std::to_string(i)));
}

std::uint64_t bytesWrittenBy(const Process& process) {
    std::ifstream file("/proc/" + std::to_string(process.number()) + "/io");
    std::uint64_t written = 0, value = 0;
    for (std::string key; file >> key >> value;)
        if (key == "wchar:" || key == "write_bytes:") written = std::max(written, value);
    return written;
}

std::uint64_t systemWorkFor(const Process& process) {
    constexpr int kBefore = 12;  // fields between the name and this one (proc(5))
    std::ifstream file("/proc/" + std::to_string(process.number()) + "/stat");
    std::string field;
    std::getline(file, field, ')');
    for (int i = 0; i < kBefore; ++i) file >> field;
    std::uint64_t ticks = 0;
    file >> ticks;
    return ticks;
}

}  // namespace glibra::system
