#pragma once
// What a way of opening a context gives to Context. Internal to this room.

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "gpu/context.h"

namespace glibra::gpu {

/// A context of some library, current on the thread that opened it. The destructor lets go of it.
class Backend {
  public:
    virtual ~Backend() = default;
    virtual bool makeCurrent() = 0;
    /// Leaves the thread without a context, so that another thread can take it.
    virtual void release() = 0;
    /// Address of a GL function, or null.
    virtual void* address(const char* function) = 0;
    [[nodiscard]] virtual Driver driver() const = 0;
    [[nodiscard]] virtual std::string description() const = 0;
};

/// A context, or one phrase a way that was tried: "EGL device 0 (/dev/dri/card0): eglInitialize failed
/// (...)".
using Attempt = std::variant<std::unique_ptr<Backend>, std::vector<std::string>>;

Attempt openEglSurfaceless(const ContextOptions& options);
Attempt openEglDevice(const ContextOptions& options);
Attempt openOsmesa(const ContextOptions& options);

/// Minor versions of GL 4 to ask for, best first.
inline constexpr int kMinorVersions[] = {6, 5, 4, 3, 2, 1};

}  // namespace glibra::gpu
