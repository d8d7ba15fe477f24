// Contexts of WGL, on a window that is never shown: Windows. Numbers are those of WGL_ARB_create_context,
// WGL_ARB_create_context_profile and WGL_ARB_create_context_robustness.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "system/library.h"
#include "system/window.h"

namespace glibra::gpu {
namespace {

constexpr int kMajorVersion = 0x2091, kMinorVersion = 0x2092, kFlags = 0x2094, kProfileMask = 0x9126;
constexpr int kCoreProfileBit = 1, kDebugFlag = 1, kRobustFlag = 4;
constexpr int kResetNotification = 0x8256, kLoseContextOnReset = 0x8252;

struct WglLibrary {
    system::Library library;
    void* (*createContext)(void* device) = nullptr;
    int (*deleteContext)(void* context) = nullptr;
    int (*makeCurrent)(void* device, void* context) = nullptr;
    void* (*currentContext)() = nullptr;
    void* (*extensionAddress)(const char* function) = nullptr;

    /// Functions of version 1.1 are those of the library itself.
    [[nodiscard]] void* address(const char* function) const {
        void* const found = extensionAddress(function);
        const auto number = reinterpret_cast<std::intptr_t>(found);
        constexpr std::intptr_t kLargestFailure = 3;  // some drivers answer 1, 2, 3 or -1
        if (number < -1 || number > kLargestFailure) return found;
        return library.address(function);
    }
};

class WglBackend final : public Backend {
  public:
    WglBackend(WglLibrary wgl, std::unique_ptr<system::HiddenWindow> window, void* context)
        : wgl_(std::move(wgl)), window_(std::move(window)), context_(context) {}
    WglBackend(const WglBackend&) = delete;
    WglBackend& operator=(const WglBackend&) = delete;
    ~WglBackend() override {
        if (WglBackend::isCurrent()) wgl_.makeCurrent(nullptr, nullptr);
        wgl_.deleteContext(context_);
    }

    bool makeCurrent() override { return wgl_.makeCurrent(window_->deviceContext(), context_) != 0; }
    [[nodiscard]] bool isCurrent() const override { return wgl_.currentContext() == context_; }
    void* address(const char* function) override { return wgl_.address(function); }
    [[nodiscard]] Driver driver() const override { return Driver::wgl; }
    [[nodiscard]] std::string description() const override { return "WGL (a window that is not shown)"; }

  private:
    WglLibrary wgl_;
    std::unique_ptr<system::HiddenWindow> window_;
    void* context_;
};

using CreateContext = void* (*)(void* device, void* shared, const int* attributes);

/// The best context that the driver offers: the highest version, one that tells of a reset before one that
/// does not. Null if it has none of version 4.1.
void* bestContext(CreateContext create, void* device, bool debug, bool isRobust) {
    for (const int minor : kMinorVersions)
        for (int care = isRobust ? 1 : 0; care >= 0; --care) {
            std::vector<int> attributes{kMajorVersion,  4, kMinorVersion, minor, kProfileMask,
                                        kCoreProfileBit};
            const int flags = (debug ? kDebugFlag : 0) | (care == 1 ? kRobustFlag : 0);
            attributes.insert(attributes.end(), {kFlags, flags});
            if (care == 1) attributes.insert(attributes.end(), {kResetNotification, kLoseContextOnReset});
            attributes.push_back(0);
            if (void* const made = create(device, nullptr, attributes.data())) return made;
        }
    return nullptr;
}

std::string tried(const std::string& why) {
    return "WGL: " + why;
}

/// The words of a driver, while a context of it is current.
std::string wordsOf(const WglLibrary& wgl) {
    constexpr unsigned kVersion = 0x1F02, kRenderer = 0x1F01;
    const auto words = reinterpret_cast<const char* (*)(unsigned)>(wgl.address("glGetString"));
    if (words == nullptr) return "unknown";
    const char* const version = words(kVersion);
    const char* const renderer = words(kRenderer);
    return std::string(renderer != nullptr ? renderer : "unknown") + ", OpenGL " +
           (version != nullptr ? version : "?");
}

Attempt openWgl(const ContextOptions& options) {
    WglLibrary wgl;
    std::string why;
    wgl.library = system::Library::open("opengl32.dll", system::Library::When::whenCalled, why);
    if (!wgl.library) return std::vector{tried(why)};
    wgl.createContext = wgl.library.find<void* (*)(void*)>("wglCreateContext");
    wgl.deleteContext = wgl.library.find<int (*)(void*)>("wglDeleteContext");
    wgl.makeCurrent = wgl.library.find<int (*)(void*, void*)>("wglMakeCurrent");
    wgl.currentContext = wgl.library.find<void* (*)()>("wglGetCurrentContext");
    wgl.extensionAddress = wgl.library.find<void* (*)(const char*)>("wglGetProcAddress");
    auto window = std::make_unique<system::HiddenWindow>();
    void* const device = window->deviceContext();
    if (device == nullptr) return std::vector{tried("no window with a pixel format for OpenGL")};

    // Only while a context is current does WGL give the function that makes one of a version.
    void* const first = wgl.createContext(device);
    if (first == nullptr || wgl.makeCurrent(device, first) == 0) {
        if (first != nullptr) wgl.deleteContext(first);
        return std::vector{tried("no context")};
    }
    const std::string words = wordsOf(wgl);
    const auto create = reinterpret_cast<CreateContext>(wgl.address("wglCreateContextAttribsARB"));
    const auto extensions =
        reinterpret_cast<const char* (*)(void*)>(wgl.address("wglGetExtensionsStringARB"));
    const char* const list = extensions != nullptr ? extensions(device) : nullptr;
    const bool isRobust =
        list != nullptr &&
        std::string_view(list).find("WGL_ARB_create_context_robustness") != std::string_view::npos;
    void* const context =
        create != nullptr ? bestContext(create, device, options.debugContext, isRobust) : nullptr;
    wgl.makeCurrent(nullptr, nullptr);
    wgl.deleteContext(first);
    if (context == nullptr) return std::vector{tried("no OpenGL 4.1 core context; the driver is " + words)};
    auto backend = std::make_unique<WglBackend>(std::move(wgl), std::move(window), context);
    if (!backend->makeCurrent()) return std::vector{tried("wglMakeCurrent failed")};
    return backend;
}

Attempt openOsmesaOfMesa(const ContextOptions& options) {
    ContextOptions windows = options;
    windows.osmesaLibraries = {"osmesa.dll"};
    return openOsmesa(windows);
}

constexpr ContextWay kWays[] = {{Driver::wgl, openWgl}, {Driver::osmesa, openOsmesaOfMesa}};

}  // namespace

std::span<const ContextWay> contextWays() {
    return kWays;
}

std::string_view adviceWithoutDriver() {
    return "Install the driver of the graphics card, or put Mesa's opengl32.dll beside glibra.exe, which "
           "draws "
           "without a graphics card (docs/windows.md)";
}

}  // namespace glibra::gpu
