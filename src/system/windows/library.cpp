#include "system/library.h"

#include <algorithm>
#include <vector>

#include "system/windows/win.h"

#include <psapi.h>

namespace glibra::system {
namespace {

/// The file of a loaded library; null: that of the program.
std::wstring fileOf(HMODULE library) {
    constexpr std::size_t kLongest = 32768;
    std::wstring file(MAX_PATH, L'\0');
    for (;;) {
        const DWORD length = ::GetModuleFileNameW(library, file.data(), static_cast<DWORD>(file.size()));
        if (length < file.size()) {
            file.resize(length);
            return file;
        }
        if (file.size() >= kLongest) return {};
        file.resize(2 * file.size());
    }
}

std::wstring lower(std::wstring text) {
    if (!text.empty()) ::CharLowerBuffW(text.data(), static_cast<DWORD>(text.size()));
    return text;
}

void* asPointer(FARPROC function) {
    return reinterpret_cast<void*>(function);
}

}  // namespace

/// A name without a folder is looked for beside the program and in the system's folder, never in the current
/// folder or PATH. A file that is named by its whole path also finds the libraries beside it. The functions
/// are always found at once.
Library Library::open(const std::string& name, When, std::string& why) {
    Library library;
    std::error_code failure;
    std::filesystem::path file(wideOf(name));
    DWORD places = LOAD_LIBRARY_SEARCH_DEFAULT_DIRS;
    if (file.has_parent_path()) {
        file = std::filesystem::absolute(file, failure).make_preferred();
        places |= LOAD_LIBRARY_SEARCH_DLL_LOAD_DIR;
    }
    const HMODULE loaded = ::LoadLibraryExW(file.c_str(), nullptr, places);
    library.handle_ = loaded;
    if (loaded == nullptr) why = name + ": " + textOf(::GetLastError());
    return library;
}

void* Library::address(const char* name) const {
    return asPointer(::GetProcAddress(static_cast<HMODULE>(handle_), name));
}

std::string moduleName(std::string_view name) {
    return std::string(name) + ".dll";
}

std::string programName(std::string_view name) {
    return std::string(name) + ".exe";
}

void* loadedFunction(const char* library, const char* name) {
    if (void* here = asPointer(::GetProcAddress(::GetModuleHandleW(nullptr), name))) return here;
    const HMODULE loaded = ::GetModuleHandleW(wideOf(library).c_str());
    return loaded == nullptr ? nullptr : asPointer(::GetProcAddress(loaded, name));
}

bool isLibraryLoaded(std::initializer_list<std::string_view> words) {
    std::vector<HMODULE> loaded(256);
    DWORD bytes = 0;
    const auto room = [&] { return static_cast<DWORD>(loaded.size() * sizeof(HMODULE)); };
    while (::EnumProcessModules(::GetCurrentProcess(), loaded.data(), room(), &bytes) && bytes > room())
        loaded.resize(bytes / sizeof(HMODULE));
    loaded.resize(bytes / sizeof(HMODULE));
    return std::ranges::any_of(loaded, [&](HMODULE each) {
        const std::wstring path = lower(fileOf(each));
        return std::ranges::any_of(words, [&](std::string_view word) {
            return path.find(lower(wideOf(word))) != std::wstring::npos;
        });
    });
}

/// A process of a service has no desktop that anybody sees.
Desktop desktop(std::string&) {
    USEROBJECTFLAGS flags{};
    const bool isKnown = ::GetUserObjectInformationW(::GetProcessWindowStation(), UOI_FLAGS, &flags,
                                                     sizeof flags, nullptr) != 0;
    return isKnown && (flags.dwFlags & WSF_VISIBLE) == 0 ? Desktop::noDisplay : Desktop::ready;
}

std::filesystem::path fileOfThisCode() {
    HMODULE self = nullptr;
    const auto* here = reinterpret_cast<const wchar_t*>(&fileOfThisCode);
    const DWORD flags = GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
    return ::GetModuleHandleExW(flags, here, &self) ? fileOf(self) : std::wstring();
}

}  // namespace glibra::system
