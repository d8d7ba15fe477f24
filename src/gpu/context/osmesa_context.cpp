// OSMesa contexts. OSMesa is Mesa's off-screen interface; Mesa dropped it in 25.1, so it is loaded at run
// time. Its functions and constants are declared here as in GL/osmesa.h, version 11.2.

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gpu/context/context.h"
#include "system/library.h"

namespace glibra::gpu {
namespace {

struct OsmesaContextRecord;
using OsmesaContext = OsmesaContextRecord*;

constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kContextMajorVersion = 0x36;
constexpr int kContextMinorVersion = 0x37;
constexpr int kRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;

struct OsmesaLibrary {
    std::string name;
    OsmesaContext (*createContextAttribs)(const int* attributes, OsmesaContext shared) = nullptr;
    void (*destroyContext)(OsmesaContext context) = nullptr;
    unsigned char (*makeCurrent)(OsmesaContext context, void* buffer, unsigned type, int width,
                                 int height) = nullptr;
    OsmesaContext (*getCurrentContext)() = nullptr;
    void* (*getProcAddress)(const char* function) = nullptr;
};

class OsmesaBackend final : public Backend {
  public:
    OsmesaBackend(OsmesaLibrary library, OsmesaContext context)
        : library_(std::move(library)), context_(context) {}
    OsmesaBackend(const OsmesaBackend&) = delete;
    OsmesaBackend& operator=(const OsmesaBackend&) = delete;
    ~OsmesaBackend() override {
        if (OsmesaBackend::isCurrent()) library_.makeCurrent(nullptr, nullptr, 0, 0, 0);
        library_.destroyContext(context_);
    }

    bool makeCurrent() override {
        return library_.makeCurrent(context_, pixel_.data(), kUnsignedByte, 1, 1) != 0;
    }
    [[nodiscard]] bool isCurrent() const override { return library_.getCurrentContext() == context_; }
    void* address(const char* function) override { return library_.getProcAddress(function); }
    [[nodiscard]] Driver driver() const override { return Driver::osmesa; }
    [[nodiscard]] std::string description() const override { return "OSMesa (" + library_.name + ")"; }

  private:
    OsmesaLibrary library_;
    OsmesaContext context_;
    std::array<std::byte, 4>
        pixel_{};  ///< the default framebuffer that OSMesa requires; nothing is drawn there
};

std::variant<OsmesaLibrary, std::string> openLibrary(const std::string& name) {
    std::string why;
    const auto library = system::Library::open(name, system::Library::When::whenCalled, why);
    if (!library) return why;
    OsmesaLibrary osmesa;
    osmesa.name = name;
    if (!library.find("OSMesaCreateContextAttribs", osmesa.createContextAttribs) ||
        !library.find("OSMesaDestroyContext", osmesa.destroyContext) ||
        !library.find("OSMesaMakeCurrent", osmesa.makeCurrent) ||
        !library.find("OSMesaGetCurrentContext", osmesa.getCurrentContext) ||
        !library.find("OSMesaGetProcAddress", osmesa.getProcAddress))
        return name + " is not an OSMesa library, or too old";
    return osmesa;
}

/// Makes the best context that the library offers, and makes it current: an older one if it has none from 4.1
/// on, which is refused later, by its version.
std::variant<std::unique_ptr<Backend>, std::string> tryLibrary(const OsmesaLibrary& library) {
    OsmesaContext context = nullptr;
    for (const int minor : kMinorVersions) {
        const std::array attributes{kFormat,
                                    kRgba,
                                    kDepthBits,
                                    0,
                                    kProfile,
                                    kCoreProfile,
                                    kContextMajorVersion,
                                    4,
                                    kContextMinorVersion,
                                    minor,
                                    0};
        if (context == nullptr) context = library.createContextAttribs(attributes.data(), nullptr);
    }
    constexpr std::array kAny{kFormat, kRgba, kDepthBits, 0, 0};
    if (context == nullptr) context = library.createContextAttribs(kAny.data(), nullptr);
    if (context == nullptr) return "no OpenGL context";
    auto backend = std::make_unique<OsmesaBackend>(library, context);
    if (!backend->makeCurrent()) return "OSMesaMakeCurrent failed";
    return backend;
}

}  // namespace

Attempt openOsmesa(const ContextOptions& options) {
    std::vector<std::string> failures;
    // OSMesa has no other drivers, and ends the process if it is asked for one (Mesa 22.3).
    const char* const asked = std::getenv("GALLIUM_DRIVER");
    const std::string_view driver = asked != nullptr ? asked : "";
    if (!driver.empty() && driver != "llvmpipe" && driver != "softpipe" && driver != "swrast") {
        failures.push_back("OSMesa: draws with llvmpipe or softpipe, but GALLIUM_DRIVER is " +
                           std::string(driver));
        return failures;
    }
    for (const std::string& name : options.osmesaLibraries) {
        const auto opened = openLibrary(name);
        if (const std::string* why = std::get_if<std::string>(&opened)) {
            failures.push_back("OSMesa: " + *why);
            continue;
        }
        const auto& library = std::get<OsmesaLibrary>(opened);
        auto outcome = tryLibrary(library);
        if (auto* backend = std::get_if<std::unique_ptr<Backend>>(&outcome)) return std::move(*backend);
        // The other names are links to this library, or older versions.
        failures.push_back("OSMesa (" + name + "): " + std::get<std::string>(outcome));
        break;
    }
    return failures;
}

}  // namespace glibra::gpu
