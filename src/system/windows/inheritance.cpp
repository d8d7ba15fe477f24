// What a process of this program gets from the one that has started it: numbers in a variable of its
// environment, among them handles.

#include <cstdint>
#include <cstdlib>
#include <utility>

#include "system/windows/win.h"

namespace glibra::system {
namespace {

std::vector<std::uint64_t> take(const wchar_t* name) {
    std::vector<std::uint64_t> numbers;
    const std::wstring value = variableText(name);
    ::SetEnvironmentVariableW(name, nullptr);
    for (const wchar_t* rest = value.c_str(); *rest != L'\0';) {
        wchar_t* end = nullptr;
        numbers.push_back(std::wcstoull(rest, &end, 10));
        if (end == rest) return {};  // somebody else has set it
        rest = *end == L':' ? end + 1 : end;
    }
    return numbers;
}

struct Inheritance {
    std::vector<std::uint64_t> ofWorker = take(kWorkerVariable), ofChild = take(kChildVariable);
};

Inheritance& inheritance() {
    static Inheritance all;
    return all;
}

}  // namespace

bool takeInheritance() {
    const Inheritance& all = inheritance();
    return !all.ofWorker.empty() || !all.ofChild.empty();
}

std::vector<std::uint64_t> inherited(const wchar_t* name) {
    Inheritance& all = inheritance();
    return std::exchange(std::wstring_view(name) == kWorkerVariable ? all.ofWorker : all.ofChild, {});
}

File takeHandle(std::uint64_t value) {
    const auto handle = reinterpret_cast<HANDLE>(static_cast<std::uintptr_t>(value));
    return ::SetHandleInformation(handle, HANDLE_FLAG_INHERIT, 0) ? ownOf(handle) : File();
}

}  // namespace glibra::system
