#include "gpu/context/fork.h"

#include "system/library.h"
#include "system/process.h"

namespace glibra::gpu {
namespace {

/// The functions by which a library says which context is current, and finds functions of GL.
struct Way {
    const char* library;
    const char* current;
    const char* address;
};
constexpr Way kWindowLibraries[] = {{"libEGL.so.1", "eglGetCurrentContext", "eglGetProcAddress"},
                                    {"libGLX.so.0", "glXGetCurrentContext", "glXGetProcAddressARB"},
                                    {"libGL.so.1", "glXGetCurrentContext", "glXGetProcAddressARB"},
                                    {"libOSMesa.so.8", "OSMesaGetCurrentContext", "OSMesaGetProcAddress"}};

/// WGL finds the functions of later versions, and its library has those of 1.1.
void* addressOfWgl(const char* name) {
    constexpr const char* kLibrary = "opengl32.dll";
    const auto find =
        reinterpret_cast<void* (*)(const char*)>(system::loadedFunction(kLibrary, "wglGetProcAddress"));
    void* const found = find != nullptr ? find(name) : nullptr;
    return found != nullptr ? found : system::loadedFunction(kLibrary, name);
}

}  // namespace

std::optional<CurrentContext> currentContext() {
    if (void* wgl = system::loadedFunction("opengl32.dll", "wglGetCurrentContext")) {
        const auto current = reinterpret_cast<void* (*)()>(wgl);
        if (void* handle = current()) return CurrentContext{handle, current, addressOfWgl};
    }
    for (const Way& way : kWindowLibraries) {
        const auto current = reinterpret_cast<void* (*)()>(system::loadedFunction(way.library, way.current));
        const auto address =
            reinterpret_cast<void* (*)(const char*)>(system::loadedFunction(way.library, way.address));
        if (current == nullptr || address == nullptr) continue;
        if (void* handle = current()) return CurrentContext{handle, current, address};
    }
    return std::nullopt;
}

namespace {

std::atomic<bool> isChild = false;

}  // namespace

void noteDriver() {
    static const bool isWatched = (system::onCopy([] { isChild = true; }), true);
    static_cast<void>(isWatched);
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
