#include "gpu/context/library.h"

#include <dlfcn.h>

namespace glibra::gpu {

std::variant<Library, std::string> Library::open(const std::string& name) {
    if (void* handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL)) return Library(handle);
    const char* why = dlerror();
    return std::string(why ? why : "cannot be opened");
}

void* Library::address(const char* name) const {
    return dlsym(handle_, name);
}

}  // namespace glibra::gpu
