#include "suite/golden/hash_key.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace glibra::suite {
namespace {

/// Processor features that change how floating point is computed, as /proc/cpuinfo names them.
constexpr std::array<std::string_view, 12> kFeatures{"sse4_1", "avx",     "avx2",     "fma",
                                                     "f16c",   "avx512f", "avx512dq", "avx512bw",
                                                     "asimd",  "asimdhp", "sve",      "vsx"};
/// Environment variables that change the code that Mesa generates.
constexpr std::array<const char*, 4> kSwitches{"GALLIUM_OVERRIDE_CPU_CAPS", "LP_NATIVE_VECTOR_WIDTH",
                                               "GALLIVM_PERF", "LP_PERF"};

/// The value of the first line "name : value" of /proc/cpuinfo, or empty.
std::string processorFact(std::string_view name) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos || !line.starts_with(name)) continue;
        if (line.find_first_not_of(" \t", name.size()) != colon) continue;
        const std::size_t begin = line.find_first_not_of(" \t", colon + 1);
        return begin == std::string::npos ? "" : line.substr(begin);
    }
    return {};
}

std::string firstOf(std::initializer_list<std::string_view> names) {
    for (const std::string_view each : names)
        if (std::string value = processorFact(each); !value.empty()) return value;
    return {};
}

std::string processor() {
    std::string words = firstOf({"vendor_id", "CPU implementer"});
    std::istringstream flags(firstOf({"flags", "Features"}));
    for (std::string flag; flags >> flag;)
        if (std::ranges::find(kFeatures, flag) != kFeatures.end()) words += " " + flag;
    return words;
}

}  // namespace

std::string driverKey(const gpu::Capabilities& driver) {
    std::string key = driver.renderer + "; " + driver.version;
    if (driver.isSoftware) {
        key += "; " + processor();
        for (const char* each : kSwitches)
            if (const char* value = std::getenv(each)) key += fmt::format("; {}={}", each, value);
    }
    std::ranges::replace_if(key, [](unsigned char c) { return c < ' '; }, ' ');  // it is one line
    return key;
}

std::vector<std::string> variantsFor(std::string_view family) {
    std::vector<std::string> words{std::string(family)};
    constexpr std::string_view kOsmesa = "osmesa-";
    if (family.starts_with(kOsmesa)) words.emplace_back(family.substr(kOsmesa.size()));
    return words;
}

std::string describeMachine() {
    utsname system{};
    ::uname(&system);
    const std::string model = firstOf({"model name", "Model", "CPU implementer"});
    return fmt::format("{}{}{} {} {}", model, model.empty() ? "" : ", ", system.sysname, system.release,
                       system.machine);
}

}  // namespace glibra::suite
