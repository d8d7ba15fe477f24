#include "system/places.h"

#include <algorithm>
#include <cstdlib>

#include "system/windows/win.h"

#include <bcrypt.h>
#include <shellapi.h>

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
