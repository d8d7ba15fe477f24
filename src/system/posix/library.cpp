#include "system/library.h"

#include <dlfcn.h>

#include <cstdlib>

#ifndef RTLD_NODELETE
#define RTLD_NODELETE 0
#endif

namespace glibra::system {

Library Library::open(const std::string& name, When when, std::string& why) {
    Library library;
    const int mode = when == When::allNow ? RTLD_NOW | RTLD_NODELETE : RTLD_LAZY;
    library.handle_ = ::dlopen(name.c_str(), mode | RTLD_LOCAL);
    if (!library) {
        const char* problem = ::dlerror();
        why = problem ? problem : "cannot be opened";
    }
    return library;
}

void* Library::address(const char* name) const {
    return ::dlsym(handle_, name);
}

std::string moduleName(std::string_view name) {
    return std::string(name) + ".so";
}

std::string programName(std::string_view name) {
    return std::string(name);
}

void* loadedFunction(const char* library, const char* name) {
    if (void* here = ::dlsym(RTLD_DEFAULT, name)) return here;
    void* loaded = ::dlopen(library, RTLD_NOW | RTLD_NOLOAD);
    if (loaded == nullptr) return nullptr;
    void* function = ::dlsym(loaded, name);
    ::dlclose(loaded);
    return function;
}

Desktop desktop(std::string& library) {
    const auto isSet = [](const char* variable) {
        const char* value = std::getenv(variable);
        return value && *value;
    };
    if (isSet("WAYLAND_DISPLAY")) return Desktop::ready;
    if (!isSet("DISPLAY")) return Desktop::noDisplay;
    // GLFW needs it, in some builds before the window can say a word of its own.
    library = "libX11.so.6";
    return ::dlopen(library.c_str(), RTLD_LAZY | RTLD_LOCAL) ? Desktop::ready : Desktop::noLibrary;
}

std::filesystem::path fileOfThisCode() {
    Dl_info self{};
    const bool isKnown = ::dladdr(reinterpret_cast<const void*>(&fileOfThisCode), &self) != 0;
    return isKnown && self.dli_fname != nullptr ? self.dli_fname : "";
}

}  // namespace glibra::system
