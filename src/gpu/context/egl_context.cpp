// EGL contexts without a surface: on the surfaceless platform (EGL_MESA_platform_surfaceless) or on a device
// (EGL_EXT_platform_device).

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/context/backend.h"
#include "gpu/context/egl_library.h"

namespace glibra::gpu {
namespace {

class EglBackend final : public Backend {
  public:
    EglBackend(EglLibrary egl, EGLDisplay display, EGLContext context, Driver driver, std::string description)
        : egl_(std::move(egl)),
          display_(display),
          context_(context),
          driver_(driver),
          description_(std::move(description)) {}
    EglBackend(const EglBackend&) = delete;
    EglBackend& operator=(const EglBackend&) = delete;
    ~EglBackend() override {
        if (EglBackend::isCurrent())
            egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_.destroyContext(display_, context_);
        // The display stays initialised: the process has one, and other code may use it.
    }

    bool makeCurrent() override {
        return egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }
    [[nodiscard]] bool isCurrent() const override { return egl_.getCurrentContext() == context_; }
    void* address(const char* function) override {
        return reinterpret_cast<void*>(egl_.getProcAddress(function));
    }
    [[nodiscard]] Driver driver() const override { return driver_; }
    [[nodiscard]] std::string description() const override { return description_; }

  private:
    EglLibrary egl_;
    EGLDisplay display_;
    EGLContext context_;
    Driver driver_;
    std::string description_;
};

/// A display to try, and its name in messages.
struct Candidate {
    EGLenum platform = 0;
    void* nativeDisplay = nullptr;
    Driver driver = Driver::egl;
    std::string name;
};

/// Any config that supports OpenGL, for libraries that cannot create a context without one.
EGLConfig anyConfig(const EglLibrary& egl, EGLDisplay display) {
    static constexpr std::array<EGLint, 5> kWanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                                   EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl.chooseConfig(display, kWanted.data(), &config, 1, &count) || count < 1) return nullptr;
    return config;
}

/// What a context is asked to do for its user's sake.
struct Care {
    bool robust = false;    ///< shaders that index outside of a buffer read zero or something else of that
                            ///< buffer, and write nothing outside (OpenGL 4.6 Core, 6.4)
    bool notifies = false;  ///< the context ends with a reset of the device, and tells so (2.3.2)
};

EGLContext createContext(const EglLibrary& egl, EGLDisplay display, EGLConfig config, bool debug, int minor,
                         const Care& care) {
    // Not forward-compatible: such a context has no wide lines.
    std::vector<EGLint> attributes{EGL_CONTEXT_MAJOR_VERSION,       4,
                                   EGL_CONTEXT_MINOR_VERSION,       minor,
                                   EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT};
    if (debug) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_DEBUG, EGL_TRUE});
    if (care.robust) attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_ROBUST_ACCESS, EGL_TRUE});
    if (care.notifies)
        attributes.insert(attributes.end(),
                          {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    attributes.push_back(EGL_NONE);
    return egl.createContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

/// The best context that an initialised display offers: the highest version, with as much care as it has.
EGLContext bestContext(const EglLibrary& egl, EGLDisplay display, EGLConfig config, bool debug,
                       const Care& most) {
    std::vector<Care> wanted{most};
    if (most.robust && most.notifies) wanted.push_back({.notifies = true});
    if (most.robust || most.notifies) wanted.push_back({.robust = most.robust && most.notifies});
    if (wanted.back().robust) wanted.emplace_back();
    for (const int minor : kMinorVersions)
        for (const Care& each : wanted)
            if (EGLContext made = createContext(egl, display, config, debug, minor, each);
                made != EGL_NO_CONTEXT)
                return made;
    return EGL_NO_CONTEXT;
}

/// Tries one display. A text says why it failed, without the candidate's name.
std::variant<std::unique_ptr<Backend>, std::string> tryDisplay(const EglLibrary& egl,
                                                               const Candidate& candidate, bool debug) {
    EGLDisplay display = egl.getPlatformDisplay(candidate.platform, candidate.nativeDisplay, nullptr);
    if (display == EGL_NO_DISPLAY) return "no display (" + egl.lastError() + ")";
    EGLint major = 0;
    EGLint minor = 0;
    if (!egl.initialize(display, &major, &minor)) return "eglInitialize failed (" + egl.lastError() + ")";

    const char* list = egl.queryString(display, EGL_EXTENSIONS);
    const std::string extensions = list ? list : "";
    if (!listHas(extensions, "EGL_KHR_surfaceless_context")) return "it needs a surface";
    if (!egl.bindApi(EGL_OPENGL_API)) return "it has OpenGL ES only";
    EGLConfig config = nullptr;
    if (!listHas(extensions, "EGL_KHR_no_config_context") &&
        !listHas(extensions, "EGL_MESA_configless_context")) {
        config = anyConfig(egl, display);
        if (!config) return "it has no config for OpenGL";
    }
    // With Mesa, robust access costs nothing that can be measured: a software rasteriser checks every access
    // anyway. It has not been measured with other drivers.
    const bool isEgl15 = major > 1 || minor >= 5;
    const Care care{.robust = isEgl15 && candidate.platform == EGL_PLATFORM_SURFACELESS_MESA &&
                              listHas(extensions, "EGL_EXT_create_context_robustness"),
                    .notifies = isEgl15 || listHas(extensions, "EGL_KHR_create_context")};
    EGLContext context = bestContext(egl, display, config, debug, care);
    if (context == EGL_NO_CONTEXT) return "no OpenGL 4.1 core context (" + egl.lastError() + ")";
    if (!egl.makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        std::string why = "eglMakeCurrent failed (" + egl.lastError() + ")";
        egl.destroyContext(display, context);
        return why;
    }
    return std::make_unique<EglBackend>(egl, display, context, candidate.driver,
                                        candidate.name + " (" + egl.name + ", EGL " + std::to_string(major) +
                                            "." + std::to_string(minor) + ")");
}

/// The first display that yields a context.
Attempt tryAll(const EglLibrary& egl, const std::vector<Candidate>& candidates, bool debug) {
    std::vector<std::string> failures;
    for (const Candidate& candidate : candidates) {
        auto outcome = tryDisplay(egl, candidate, debug);
        if (auto* backend = std::get_if<std::unique_ptr<Backend>>(&outcome)) return std::move(*backend);
        failures.push_back(candidate.name + ": " + std::get<std::string>(outcome));
    }
    return failures;
}

/// All devices, software devices last.
std::vector<Candidate> devices(const EglLibrary& egl) {
    constexpr EGLint kMost = 64;
    std::array<EGLDeviceEXT, kMost> found{};
    EGLint count = 0;
    if (!egl.queryDevices(kMost, found.data(), &count)) return {};
    std::vector<Candidate> hardware;
    std::vector<Candidate> software;
    for (EGLint i = 0; i < count; ++i) {
        EGLDeviceEXT device = found[static_cast<std::size_t>(i)];
        const char* list = egl.queryDeviceString ? egl.queryDeviceString(device, EGL_EXTENSIONS) : nullptr;
        const std::string_view extensions = list ? list : "";
        std::string name = "EGL device " + std::to_string(i);
        if (listHas(extensions, "EGL_EXT_device_drm"))
            if (const char* file = egl.queryDeviceString(device, EGL_DRM_DEVICE_FILE_EXT))
                name += std::string(" ") + file;
        (listHas(extensions, "EGL_MESA_device_software") ? software : hardware)
            .push_back({EGL_PLATFORM_DEVICE_EXT, device, Driver::eglDevice, std::move(name)});
    }
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
}

}  // namespace

Attempt openEglSurfaceless(const ContextOptions& options) {
    const auto opened = openEglLibrary(options.eglLibrary);
    if (const std::string* why = std::get_if<std::string>(&opened))
        return std::vector<std::string>{"EGL without a surface: " + *why};
    const auto& egl = std::get<EglLibrary>(opened);
    if (!egl.getPlatformDisplay || !egl.hasClientExtension("EGL_MESA_platform_surfaceless"))
        return std::vector<std::string>{"EGL without a surface: " + egl.name +
                                        " has no EGL_MESA_platform_surfaceless"};
    return tryAll(egl, {{EGL_PLATFORM_SURFACELESS_MESA, nullptr, Driver::egl, "EGL without a surface"}},
                  options.debugContext);
}

Attempt openEglDevice(const ContextOptions& options) {
    const auto opened = openEglLibrary(options.eglLibrary);
    if (const std::string* why = std::get_if<std::string>(&opened))
        return std::vector<std::string>{"EGL device: " + *why};
    const auto& egl = std::get<EglLibrary>(opened);
    if (!egl.getPlatformDisplay || !egl.queryDevices || !egl.hasClientExtension("EGL_EXT_platform_device"))
        return std::vector<std::string>{"EGL device: " + egl.name + " has no EGL_EXT_platform_device"};
    const std::vector<Candidate> candidates = devices(egl);
    if (candidates.empty()) return std::vector<std::string>{"EGL device: " + egl.name + " lists no device"};
    return tryAll(egl, candidates, options.debugContext);
}

}  // namespace glibra::gpu
