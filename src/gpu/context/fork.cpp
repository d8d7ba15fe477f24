#include "gpu/context/fork.h"

#include <dlfcn.h>
#include <pthread.h>

namespace glibra::gpu {
namespace {

/// A function that this process has: in the common scope, or of a library that is loaded in whatever scope.
void* functionOf(const char* library, const char* name) {
    if (void* here = ::dlsym(RTLD_DEFAULT, name)) return here;
    void* loaded = ::dlopen(library, RTLD_NOW | RTLD_NOLOAD);
    if (loaded == nullptr) return nullptr;
    void* function = ::dlsym(loaded, name);
    ::dlclose(loaded);
    return function;
}

/// The functions by which a library says which context is current, and finds functions of GL.
struct Way {
    const char* library;
    const char* current;
    const char* address;
};
constexpr Way kWays[] = {{"libEGL.so.1", "eglGetCurrentContext", "eglGetProcAddress"},
                         {"libGLX.so.0", "glXGetCurrentContext", "glXGetProcAddressARB"},
                         {"libGL.so.1", "glXGetCurrentContext", "glXGetProcAddressARB"},
                         {"libOSMesa.so.8", "OSMesaGetCurrentContext", "OSMesaGetProcAddress"}};

}  // namespace

std::optional<CurrentContext> currentContext() {
    for (const Way& way : kWays) {
        const auto current = reinterpret_cast<void* (*)()>(functionOf(way.library, way.current));
        const auto address = reinterpret_cast<void* (*)(const char*)>(functionOf(way.library, way.address));
        if (current == nullptr || address == nullptr) continue;
        if (void* handle = current()) return CurrentContext{handle, current, address};
    }
    return std::nullopt;
}

namespace {

std::atomic<bool> isChild = false;

}  // namespace

void noteDriver() {
    static const int watched = ::pthread_atfork(nullptr, nullptr, [] { isChild = true; });
    static_cast<void>(watched);
}

bool isForked() {
    return isChild;
}

std::string forkedText() {
    return "a process that is forked after a renderer was opened cannot draw, because the driver's threads "
           "are "
           "not in it; fork before, or start the process anew (exec; in Python the start methods 'spawn' and "
           "'forkserver')";
}

}  // namespace glibra::gpu
