#include "system/places.h"

#include <stdlib.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace glibra::system {

namespace fs = std::filesystem;

namespace {

/// A variable that has a value.
const char* valueOf(const char* variable) {
    const char* value = std::getenv(variable);
    return value && *value ? value : nullptr;
}

}  // namespace

fs::path userFolder(UserFolder which) {
    // https://specifications.freedesktop.org/basedir-spec
    struct Place {
        const char* variable;
        const char* usual;
    };
    constexpr Place kPlaces[] = {
        {"XDG_CONFIG_HOME", ".config"}, {"XDG_STATE_HOME", ".local/state"}, {"XDG_CACHE_HOME", ".cache"}};
    const Place& place = kPlaces[static_cast<int>(which)];
    if (const char* folder = valueOf(place.variable)) return fs::path(folder) / "glibra";
    if (const char* home = valueOf("HOME")) return fs::path(home) / place.usual / "glibra";
    return {};
}

fs::path homeFolder() {
    const char* home = std::getenv("HOME");
    return home ? home : "";
}

std::vector<fs::path> foldersIn(const char* variable) {
    std::vector<fs::path> folders;
    const char* value = std::getenv(variable);
    std::string_view rest = value ? value : "";
    while (!rest.empty()) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        if (!folder.empty()) folders.emplace_back(folder);
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
    return folders;
}

fs::path fontFile(const std::string& name) {
    std::vector<fs::path> folders = foldersIn("XDG_DATA_DIRS");
    if (folders.empty()) folders = {"/usr/local/share", "/usr/share"};
    for (const fs::path& each : folders) {
        const fs::path file = each / "fonts/truetype/dejavu" / name;
        std::error_code failure;
        if (fs::is_regular_file(file, failure)) return file;
    }
    return {};
}

bool mayWrite(const fs::path& path) {
    return ::access(path.c_str(), W_OK) == 0;
}

void setVariable(const char* name, const std::string& value, Replace replace) {
    ::setenv(name, value.c_str(), replace == Replace::yes ? 1 : 0);
}

void removeVariable(const char* name) {
    ::unsetenv(name);
}

std::optional<LocalTime> localTime(std::time_t seconds) {
    LocalTime local;
    if (::localtime_r(&seconds, &local.time) == nullptr) return std::nullopt;
    local.minutesAhead = local.time.tm_gmtoff / 60;
    return local;
}

double processorSeconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool fillWithRandom(std::span<std::byte> bytes) {
    return ::getentropy(bytes.data(), bytes.size()) == 0;
}

std::string systemName() {
    utsname system{};
    if (::uname(&system) != 0) return {};
    return std::string(system.sysname) + " " + system.release + " " + system.machine;
}

std::string processorModel() {
    constexpr std::string_view kNames[] = {"model name", "Model", "CPU implementer"};
    return processorFact(kNames);
}

GraphicsCard graphicsCard(const fs::path& given) {
    const fs::path devices = given.empty() ? "/dev" : given;
    const auto canOpen = [](const fs::path& file) { return ::access(file.c_str(), R_OK | W_OK) == 0; };
    if (canOpen(devices / "nvidiactl")) return GraphicsCard::ownDriver;
    if (canOpen(devices / "dxg")) return GraphicsCard::mesa;
    std::error_code failure;
    for (fs::directory_iterator each(devices / "dri", failure), end; !failure && each != end;
         each.increment(failure))
        if (each->path().filename().string().starts_with("renderD") && canOpen(each->path()))
            return GraphicsCard::mesa;
    return GraphicsCard::none;
}

std::uint64_t machineMemory() {
    return static_cast<std::uint64_t>(std::max(0L, ::sysconf(_SC_PHYS_PAGES))) *
           static_cast<std::uint64_t>(std::max(1L, ::sysconf(_SC_PAGESIZE)));
}

}  // namespace glibra::system
