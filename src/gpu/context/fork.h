#pragma once
// What a process inherits by fork() and cannot use: contexts of its parent. The threads of their drivers are
// not in it, so that every call would wait for ever, and what is on the device belongs to the parent.

#include <atomic>
#include <optional>
#include <string>
#include <utility>

namespace glibra::gpu {

// The context that a library of others (GLFW, SDL, Qt, ...) made current on this thread.

struct CurrentContext {
    void* handle = nullptr;                   ///< of EGL, GLX or OSMesa
    void* (*currentHandle)() = nullptr;       ///< the handle that is current now, or null
    void* (*address)(const char*) = nullptr;  ///< of a GL function, for all contexts of this kind
};

/// Nothing if the process has no library by which a context is current on the calling thread.
std::optional<CurrentContext> currentContext();

/// Notes that the process uses a driver. Processes that are forked from now on cannot.
void noteDriver();

/// True in a process that was forked after noteDriver(), and in those that it forks; not after exec(). Such a
/// process must call no function of a driver, neither with what it inherits nor with a new context.
bool isForked();

/// Why a forked process cannot draw, and what can (gpu-E08).
std::string forkedText();

/// Keeps a value to the end of the process without ending it: what is on a device that cannot be reached.
/// Takes no lock, which another thread of the parent may have held.
template <class T>
void keepForever(T value) {
    struct Kept {
        T value;
        Kept* next = nullptr;
    };
    static std::atomic<Kept*> first = nullptr;
    auto* const kept = new Kept{std::move(value)};
    kept->next = first.load();
    while (!first.compare_exchange_weak(kept->next, kept)) {
    }
}

}  // namespace glibra::gpu
