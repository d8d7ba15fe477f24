#include "system/places.h"

#include <cpuid.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "system/windows/win.h"

#include <bcrypt.h>
#include <shellapi.h>
#include <winternl.h>

namespace glibra::system {

namespace fs = std::filesystem;

fs::path programFile() {
    constexpr std::size_t kLongest = 32768;
    std::wstring file(kLongest, L'\0');
    file.resize(::GetModuleFileNameW(nullptr, file.data(), static_cast<DWORD>(file.size())));
    return file;
}

std::string pathOfThisProgram() {
    return narrowOf(programFile().native());
}

std::vector<std::string> ownWords() {
    int count = 0;
    wchar_t** const all = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    std::vector<std::string> words;
    for (int i = 0; all != nullptr && i < count; ++i) words.push_back(narrowOf(all[i]));
    ::LocalFree(all);
    return words;
}

fs::path userFolder(UserFolder which) {
    const fs::path place = variableText(which == UserFolder::settings ? L"APPDATA" : L"LOCALAPPDATA");
    if (place.empty()) return {};
    if (which == UserFolder::settings) return place / L"glibra";
    return place / L"glibra" / (which == UserFolder::state ? L"state" : L"cache");
}

fs::path homeFolder() {
    return variableText(L"USERPROFILE");
}

/// Fonts are installed for all users, or for one.
fs::path fontFile(const std::string& name) {
    // The package brings the letters that other systems have.
    if (const fs::path own = programFile().parent_path() / L"fonts" / wideOf(name);
        kindOf(own, Links::followed) == FileKind::regular)
        return own;
    const std::pair<const wchar_t*, const wchar_t*> places[] = {
        {L"SystemRoot", L"Fonts"}, {L"LOCALAPPDATA", LR"(Microsoft\Windows\Fonts)"}};
    for (const auto& [variable, folder] : places) {
        const fs::path file = fs::path(variableText(variable)) / folder / wideOf(name);
        if (kindOf(file, Links::followed) == FileKind::regular) return file;
    }
    return {};
}

std::vector<fs::path> foldersIn(const char* variable) {
    std::vector<fs::path> folders;
    const std::wstring value = variableText(wideOf(variable).c_str());
    std::wstring folder;
    bool isQuoted = false;  // a folder whose name has a semicolon
    for (const wchar_t each : value + L';') {
        if (each == L'"') {
            isQuoted = !isQuoted;
        } else if (each == L';' && !isQuoted) {
            if (!folder.empty()) folders.emplace_back(folder);
            folder.clear();
        } else {
            folder += each;
        }
    }
    return folders;
}

bool mayWrite(const fs::path& path) {
    // For a folder the right is FILE_ADD_FILE, which is the same bit.
    return static_cast<bool>(openExisting(path, FILE_WRITE_DATA, FILE_FLAG_BACKUP_SEMANTICS));
}

/// Both for this C runtime and for the system, by which other runtimes and programs get it. The C runtime has
/// no variables that are empty.
void setVariable(const char* name, const std::string& value, Replace replace) {
    const std::wstring wide = wideOf(name), text = wideOf(value);
    ::SetLastError(ERROR_SUCCESS);
    const bool isSet =
        ::GetEnvironmentVariableW(wide.c_str(), nullptr, 0) > 0 || ::GetLastError() != ERROR_ENVVAR_NOT_FOUND;
    if (isSet && replace == Replace::no) return;
    ::_wputenv((wide + L'=' + text).c_str());
    ::SetEnvironmentVariableW(wide.c_str(), text.c_str());
}

void removeVariable(const char* name) {
    const std::wstring wide = wideOf(name);
    ::_wputenv((wide + L'=').c_str());
    ::SetEnvironmentVariableW(wide.c_str(), nullptr);
}

std::optional<LocalTime> localTime(std::time_t seconds) {
    LocalTime local;
    if (::_localtime64_s(&local.time, &seconds) != 0) return std::nullopt;
    std::tm asIfUtc = local.time;
    local.minutesAhead = static_cast<long>((::_mkgmtime64(&asIfUtc) - seconds) / 60);
    return local;
}

double processorSeconds() {
    FILETIME made{}, ended{}, system{}, user{};
    ::GetProcessTimes(::GetCurrentProcess(), &made, &ended, &system, &user);
    constexpr double kSeconds = 1e-7, kHigh = 4294967296;
    return kSeconds * (kHigh * (system.dwHighDateTime + user.dwHighDateTime) + system.dwLowDateTime +
                       user.dwLowDateTime);
}

bool fillWithRandom(std::span<std::byte> bytes) {
    return ::BCryptGenRandom(nullptr, reinterpret_cast<unsigned char*>(bytes.data()),
                             static_cast<ULONG>(bytes.size()), BCRYPT_USE_SYSTEM_PREFERRED_RNG) >= 0;
}

std::uint64_t machineMemory() {
    MEMORYSTATUSEX memory{};
    memory.dwLength = sizeof memory;
    return ::GlobalMemoryStatusEx(&memory) ? memory.ullTotalPhys : 0;
}

/// Also what a job lets all its processes have.
std::uint64_t usableMemory() {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    const std::uint64_t all = machineMemory();
    const bool isLimited = ::QueryInformationJobObject(nullptr, JobObjectExtendedLimitInformation, &limits,
                                                       sizeof limits, nullptr) != 0 &&
                           (limits.BasicLimitInformation.LimitFlags & JOB_OBJECT_LIMIT_JOB_MEMORY) != 0;
    return isLimited ? std::min<std::uint64_t>(all, limits.JobMemoryLimit) : all;
}

}  // namespace glibra::system

// What Windows says of itself and of the processor.

// Not in the headers of MinGW.
extern "C" NTSTATUS NTAPI RtlGetVersion(PRTL_OSVERSIONINFOW);

namespace glibra::system {
namespace {

std::string processorValue(const wchar_t* name) {
    constexpr DWORD kLongest = 256;
    std::array<wchar_t, kLongest> text{};
    DWORD bytes = sizeof text - sizeof(wchar_t);
    if (::RegGetValueW(HKEY_LOCAL_MACHINE, LR"(HARDWARE\DESCRIPTION\System\CentralProcessor\0)", name,
                       RRF_RT_REG_SZ, nullptr, text.data(), &bytes) != ERROR_SUCCESS)
        return {};
    std::string value = narrowOf(text.data());
    while (!value.empty() && value.back() == ' ') value.pop_back();
    return value;
}

/// Instruction sets by their names on Linux: those that change how programs compute.
std::string flags() {
    struct Flag {
        const char* name;
        bool isThere;
    };
    unsigned a = 0, b = 0, c = 0, d = 0, extendedB = 0, extendedC = 0, unused = 0;
    __get_cpuid(1, &a, &b, &c, &d);
    __get_cpuid_count(7, 0, &unused, &extendedB, &extendedC, &unused);
    const Flag all[] = {{"sse2", (d & bit_SSE2) != 0},
                        {"pni", (c & bit_SSE3) != 0},
                        {"ssse3", (c & bit_SSSE3) != 0},
                        {"fma", (c & bit_FMA) != 0},
                        {"sse4_1", (c & bit_SSE4_1) != 0},
                        {"sse4_2", (c & bit_SSE4_2) != 0},
                        {"popcnt", (c & bit_POPCNT) != 0},
                        {"avx", (c & bit_AVX) != 0},
                        {"f16c", (c & bit_F16C) != 0},
                        {"bmi1", (extendedB & bit_BMI) != 0},
                        {"avx2", (extendedB & bit_AVX2) != 0},
                        {"bmi2", (extendedB & bit_BMI2) != 0},
                        {"avx512f", (extendedB & bit_AVX512F) != 0},
                        {"avx512dq", (extendedB & bit_AVX512DQ) != 0},
                        {"avx512cd", (extendedB & bit_AVX512CD) != 0},
                        {"avx512bw", (extendedB & bit_AVX512BW) != 0},
                        {"avx512vl", (extendedB & bit_AVX512VL) != 0}};
    std::string names;
    for (const auto& [name, isThere] : all)
        if (isThere) names += (names.empty() ? "" : " ") + std::string(name);
    return names;
}

}  // namespace

std::string systemName() {
    RTL_OSVERSIONINFOW version{};
    version.dwOSVersionInfoSize = sizeof version;
    if (::RtlGetVersion(&version) < 0) return {};
    SYSTEM_INFO machine{};
    ::GetNativeSystemInfo(&machine);
    const char* kind = machine.wProcessorArchitecture == PROCESSOR_ARCHITECTURE_ARM64 ? "arm64" : "x86_64";
    return "Windows " + std::to_string(version.dwMajorVersion) + "." +
           std::to_string(version.dwMinorVersion) + "." + std::to_string(version.dwBuildNumber) + " " + kind;
}

std::string processorFact(std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        std::string value;
        if (name == "model name") value = processorValue(L"ProcessorNameString");
        if (name == "vendor_id") value = processorValue(L"VendorIdentifier");
        if (name == "flags") value = flags();
        if (!value.empty()) return value;
    }
    return {};
}

std::string processorModel() {
    return processorValue(L"ProcessorNameString");
}

/// Cards have drivers of their own. Windows draws what has none, and what is far away, by itself.
GraphicsCard graphicsCard(const std::filesystem::path& devices) {
    if (!devices.empty()) return GraphicsCard::none;  // there are no such files
    DISPLAY_DEVICEW found{};
    found.cb = sizeof found;
    for (DWORD i = 0; ::EnumDisplayDevicesW(nullptr, i, &found, 0); ++i)
        if (!std::wstring_view(found.DeviceString).starts_with(L"Microsoft ")) return GraphicsCard::ownDriver;
    return GraphicsCard::none;
}

}  // namespace glibra::system
