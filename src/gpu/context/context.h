#pragma once
// A GL context without a window: EGL without a surface, an EGL device (NVIDIA), OSMesa, WGL (Windows), or an
// adopted one that another library made. All are opened at run time; the program links none.
// A thread uses one context at a time. The process has one table of GL functions; therefore contexts that
// exist on different threads are of one driver, and opening one of another driver there is an error.
// A context belongs to the thread that opened it. Every GL object must be destroyed before
// its context. After the driver has reset the device, whatever is read with the context throws
// base::DeviceLost (driver_reports.h), until another one is opened.

#include <glibra/driver.h>
#include <glibra/result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gpu/context/capabilities.h"
#include "gpu/context/driver_reports.h"

namespace glibra::gpu {

// Which context is opened, and how.

using glibra::Driver;

struct ContextOptions {
    Driver driver = Driver::automatic;
    bool debugContext =
        false;  ///< requests the driver's own checks as well; errors are collected in any case
    /// Makes llvmpipe filter byte textures in float, as hardware does. This sets the environment variable
    /// GALLIVM_PERF unless the user has set it, and takes effect at the first context of a process.
    bool floatFiltering = true;
    std::string eglLibrary = "libEGL.so.1";
    std::vector<std::string> osmesaLibraries = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
};

// One way of opening a context, as Context uses it. Internal to this room.

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

Attempt openOsmesa(const ContextOptions& options);

struct ContextWay {
    Driver driver;
    Attempt (*open)(const ContextOptions&);
};
/// Those of this system, best first. egl_context.cpp has them for all systems but Windows, wgl_context.cpp
/// for that.
std::span<const ContextWay> contextWays();
/// Fills the table of functions from a context of OpenGL that is current. False below version 4.1, and where
/// there is OpenGL ES alone (web_context.cpp).
bool loadCoreFunctions(Backend& backend);
/// What a user can do who has no driver, as a sentence without its full stop.
std::string_view adviceWithoutDriver();

/// The minor versions of GL 4 to request, best first.
inline constexpr int kMinorVersions[] = {6, 5, 4, 3, 2, 1};

class Context {
  public:
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;
    ~Context();

    [[nodiscard]] const Capabilities& capabilities() const;
    /// The driver's messages so far. The log keeps its address while the context exists.
    [[nodiscard]] DebugLog& debugLog() const;
    /// The driver that was opened; `automatic` for an adopted context.
    [[nodiscard]] Driver driver() const;
    /// How it was opened, as one phrase: "EGL without a surface (libEGL.so.1, EGL 1.5)".
    [[nodiscard]] const std::string& howOpened() const;
    /// The ways that were tried first and why they failed, one phrase each; empty if the first way worked.
    [[nodiscard]] const std::vector<std::string>& failedWays() const;
    /// True if it is current on the calling thread. An adopted one of a library that is not known
    /// (fork.h) is taken to be.
    [[nodiscard]] bool isCurrent() const;
    /// Makes the context current on the calling thread again after another one was. False if the driver
    /// refuses, as it does while it is current on another thread, and for an adopted one that is not current.
    bool makeCurrent();
    /// Adopts another context in place of an adopted one that is lost; it is current on this thread. No GL
    /// object of the lost one may exist any more. This object and its log keep their addresses. Reports
    /// gpu-E01.
    Diagnostics adoptAgain(const std::function<void*(const char*)>& loader);

  private:
    friend Result<Context> openContext(const ContextOptions& options);
    friend Result<Context> adopt(const std::function<void*(const char*)>& loader);
    struct State;
    explicit Context(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Sets the state that every picture starts from, where it differs from GL's own.
void setInitialState();

/// Opens a core profile context of the highest version that the driver has, at least 4.1, and makes it
/// current on the calling thread. It has the state that every picture starts from: seamless cube maps,
/// tightly packed pixel rows, no dithering. The error gpu-E01 names each way that was tried and why it
/// failed.
Result<Context> openContext(const ContextOptions& options = {});

/// Sets the environment variables that drivers read when they are loaded (ContextOptions::floatFiltering).
/// openContext calls it. Call it before making a context to adopt, and before any thread exists.
void prepareEnvironment(const ContextOptions& options = {});

/// Adopts a context that is current on this thread, such as a window's. `loader` returns the address of a GL
/// function or null. The adopted context is not destroyed with the Context. Reports gpu-E01 if it is older
/// than 4.1.
Result<Context> adopt(const std::function<void*(const char*)>& loader);

// Whether a graphics card may draw, found without the cost of opening a context, and how many processes
// should draw with it.

/// False if openContext(driver) will draw on the processor. It looks at LIBGL_ALWAYS_SOFTWARE and for
/// graphics cards (system/places.h: in the folder `devices` if that is not empty), and loads no library. True
/// is not a guarantee: a device may lack a driver.
bool mayUseHardware(Driver driver, const std::filesystem::path& devices = {});

/// The number of processes that draw `pieces` scenes soonest, if each opens a context of its own. Where the
/// processor draws, that is one per processor. Contexts of a graphics card are made one after the other, and
/// making one takes as long as four scenes (NVIDIA H100, driver 580: 92 ms and 23 ms), so few pieces are
/// drawn by one process, and many by at most four.
int usualWorkers(Driver driver, std::size_t pieces, int processors,
                 const std::filesystem::path& devices = {});

// Everything about the driver that `glibra info` prints.

struct InfoEntry {
    std::string key;    ///< for JSON: camelCase, never changes meaning
    std::string label;  ///< for people: "largest 2D texture"
    std::variant<std::string, std::int64_t, double, bool> value;
};

/// Entries in the order of display: how the context was opened, driver, versions, limits, number of
/// extensions.
std::vector<InfoEntry> describe(const Context& context);

/// One "label: value" line per entry, with the values aligned.
std::string toText(const std::vector<InfoEntry>& entries);

}  // namespace glibra::gpu
