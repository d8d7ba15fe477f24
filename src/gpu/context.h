#pragma once
// A GL context without a window: EGL without a surface, an EGL device (NVIDIA), OSMesa, or one that somebody
// else made. Libraries are opened at run time, so that the program links neither EGL nor OSMesa.
//
// One context is used at a time in a process: the table of GL functions is one for all. A context belongs to
// the thread that opened it. Every GL object must go before its context does.

#include <glibra/render.h>
#include <glibra/result.h>

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/capabilities.h"
#include "gpu/debug.h"

namespace glibra::gpu {

using glibra::Driver;

struct ContextOptions {
    Driver driver = Driver::automatic;
    bool debugContext = false;  ///< asks the driver for its own checks too; errors are collected in any case
    /// Makes llvmpipe filter byte textures in float, as hardware does, by the environment variable
    /// GALLIVM_PERF unless the user has set it. Takes effect at the first context of a process.
    bool floatFiltering = true;
    std::string eglLibrary = "libEGL.so.1";
    std::vector<std::string> osmesaLibraries = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
};

class Context {
  public:
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    [[nodiscard]] const Capabilities& capabilities() const;
    /// What the driver said so far. It stays at its address while the context lives.
    [[nodiscard]] DebugLog& debugLog() const;
    /// Which one it became; `automatic` for an adopted context.
    [[nodiscard]] Driver driver() const;
    /// One phrase for people: "EGL without a surface (libEGL.so.1, EGL 1.5)".
    [[nodiscard]] const std::string& howOpened() const;
    /// What was tried before it and why it failed, one phrase each; empty if the first way worked.
    [[nodiscard]] const std::vector<std::string>& failedWays() const;
    /// Makes it current on the calling thread again (after another context was); false if the driver refuses.
    bool makeCurrent();

  private:
    friend class ContextOpening;
    friend Result<Context> openContext(const ContextOptions& options);
    friend Result<Context> adopt(const std::function<void*(const char*)>& loader);
    struct State;
    explicit Context(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Opens a core profile context of the highest version the driver has (4.1 at least), current on the calling
/// thread, with the state that every picture starts from: seamless cube maps, tightly packed pixel rows, no
/// dithering. The error gpu-E01 is one sentence that names each way tried and why it failed.
Result<Context> openContext(const ContextOptions& options = {});

/// Opens a context in a thread of its own while the caller reads the scene: most of the time it takes (20 ms
/// on llvmpipe) goes into loading the driver.
///
///     gpu::ContextOpening opening(options);
///     ... parse, interpret, make meshes: anything without GL ...
///     Result<gpu::Context> context = opening.finish();
class ContextOpening {
  public:
    explicit ContextOpening(const ContextOptions& options = {});
    /// The context, now current on the calling thread, or what openContext would have said. Call it once.
    /// Without the call the destructor waits and closes the context.
    Result<Context> finish();

  private:
    ContextOptions options_;
    std::future<Result<Context>> pending_;
};

/// Sets what drivers read from the environment when they are loaded (ContextOptions::floatFiltering).
/// openContext does it by itself; who makes a context to adopt calls it first, before any thread exists.
void prepareEnvironment(const ContextOptions& options = {});

/// Takes over a context that is current on this thread (a window's). `loader` gives the address of a GL
/// function or null. It is not destroyed with the Context. gpu-E01 if it is older than 4.1.
Result<Context> adopt(const std::function<void*(const char*)>& loader);

/// The word of a driver as on the command line: "auto", "egl", "egl-device", "osmesa".
std::string_view word(Driver driver);
/// The driver of that word; gpu-E01 names the words there are.
Result<Driver> driverOfWord(std::string_view word);

}  // namespace glibra::gpu
