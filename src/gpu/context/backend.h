#pragma once
// One way of opening a context, as Context uses it. Internal to this room.

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "gpu/context/context_options.h"

namespace glibra::gpu {

/// A context of one library, current on the thread that opened it. The destructor releases it.
class Backend {
  public:
    virtual ~Backend() = default;
    /// False if that is not possible. An adopted context is made current by others alone.
    virtual bool makeCurrent() = 0;
    /// True if it is current on this thread.
    [[nodiscard]] virtual bool isCurrent() const = 0;
    /// The address of a GL function, or null.
    virtual void* address(const char* function) = 0;
    [[nodiscard]] virtual Driver driver() const = 0;
    [[nodiscard]] virtual std::string description() const = 0;
};

/// A context, or one phrase per way that was tried: "EGL device 0 (/dev/dri/card0): eglInitialize failed
/// (...)".
using Attempt = std::variant<std::unique_ptr<Backend>, std::vector<std::string>>;

Attempt openEglSurfaceless(const ContextOptions& options);
Attempt openEglDevice(const ContextOptions& options);
Attempt openOsmesa(const ContextOptions& options);

/// The minor versions of GL 4 to request, best first.
inline constexpr int kMinorVersions[] = {6, 5, 4, 3, 2, 1};

}  // namespace glibra::gpu
