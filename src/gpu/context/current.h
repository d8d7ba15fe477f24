#pragma once
// The context that a library of others (GLFW, SDL, Qt, ...) made current on this thread.

#include <optional>

namespace glibra::gpu {

struct CurrentContext {
    void* handle = nullptr;                   ///< of EGL, GLX or OSMesa
    void* (*currentHandle)() = nullptr;       ///< the handle that is current now, or null
    void* (*address)(const char*) = nullptr;  ///< of a GL function, for all contexts of this kind
};

/// Nothing if the process has no library by which a context is current on the calling thread.
std::optional<CurrentContext> currentContext();

}  // namespace glibra::gpu
