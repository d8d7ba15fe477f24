// EGL contexts without a surface: on the surfaceless platform (EGL_MESA_platform_surfaceless) or on a device
// (EGL_EXT_platform_device).

#include <fmt/format.h>
#include <glad/egl.h>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gpu/context/context.h"
#include "system/library.h"

namespace glibra::gpu {
namespace {

// The EGL functions that opening a context needs, resolved at run time. Internal to this room.

struct EglLibrary {
    std::string name;
    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLGETERRORPROC getError = nullptr;
    PFNEGLQUERYSTRINGPROC queryString = nullptr;
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLCHOOSECONFIGPROC chooseConfig = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;
    PFNEGLGETCURRENTCONTEXTPROC getCurrentContext = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;            ///< null without EGL_EXT_device_enumeration
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;  ///< null without EGL_EXT_device_query
    std::string clientExtensions;

    /// True if the client extension list names it.
    [[nodiscard]] bool hasClientExtension(std::string_view extension) const;
    /// The name of the last error: "EGL_BAD_MATCH".
    [[nodiscard]] std::string lastError() const;
};

/// True if the blank-separated list holds exactly that word.
bool listHas(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t blank = list.find(' ');
        if (list.substr(0, blank) == word) return true;
        if (blank == std::string_view::npos) break;
        list.remove_prefix(blank + 1);
    }
    return false;
}

bool EglLibrary::hasClientExtension(std::string_view extension) const {
    return listHas(clientExtensions, extension);
}

std::string EglLibrary::lastError() const {
    static constexpr std::array<std::pair<EGLint, const char*>, 13> kWords{{
        {EGL_SUCCESS, "no error given"},
        {EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
        {EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
        {EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
        {EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
        {EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
        {EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
        {EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
        {EGL_BAD_MATCH, "EGL_BAD_MATCH"},
        {EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
        {EGL_BAD_SURFACE, "EGL_BAD_SURFACE"},
        {EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
        {EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE"},
    }};
    const EGLint code = getError();
    for (const auto& [value, text] : kWords)
        if (value == code) return text;
    return "error " + std::to_string(code);
}

/// Opens the library of that name; a text says why it cannot be used.
std::variant<EglLibrary, std::string> openEglLibrary(const std::string& name) {
    std::string why;
    const auto library = system::Library::open(name, system::Library::When::whenCalled, why);
    if (!library) return why;

    EglLibrary egl;
    egl.name = name;
    if (!library.find("eglGetProcAddress", egl.getProcAddress) ||
        !library.find("eglGetError", egl.getError) || !library.find("eglQueryString", egl.queryString) ||
        !library.find("eglInitialize", egl.initialize) || !library.find("eglBindAPI", egl.bindApi) ||
        !library.find("eglChooseConfig", egl.chooseConfig) ||
        !library.find("eglCreateContext", egl.createContext) ||
        !library.find("eglDestroyContext", egl.destroyContext) ||
        !library.find("eglMakeCurrent", egl.makeCurrent) ||
        !library.find("eglGetCurrentContext", egl.getCurrentContext))
        return name + " is not an EGL library";

    // Null for EGL libraries without client extensions.
    if (const char* extensions = egl.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS))
        egl.clientExtensions = extensions;
    const auto extensionFunction = [&](const char* function) { return egl.getProcAddress(function); };
    if (egl.hasClientExtension("EGL_EXT_platform_base"))
        egl.getPlatformDisplay =
            reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(extensionFunction("eglGetPlatformDisplayEXT"));
    if (egl.hasClientExtension("EGL_EXT_device_enumeration") || egl.hasClientExtension("EGL_EXT_device_base"))
        egl.queryDevices =
            reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(extensionFunction("eglQueryDevicesEXT"));
    if (egl.hasClientExtension("EGL_EXT_device_query") || egl.hasClientExtension("EGL_EXT_device_base"))
        egl.queryDeviceString =
            reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(extensionFunction("eglQueryDeviceStringEXT"));
    return egl;
}

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
EGLConfig anyConfig(const EglLibrary& egl, EGLDisplay display, bool isEs) {
    const std::array<EGLint, 5> kWanted{EGL_RENDERABLE_TYPE, isEs ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                                        EGL_SURFACE_TYPE, 0, EGL_NONE};
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

/// The best context that an initialised display offers: the highest version, with as much care as it has; an
/// older one if it has none from 4.1 on.
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
    // Whatever else it has is refused later, by its version.
    return egl.createContext(display, config, EGL_NO_CONTEXT, nullptr);
}

EGLContext esContext(const EglLibrary& egl, EGLDisplay display, EGLConfig config) {
    constexpr std::array<EGLint, 3> kAttributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    return egl.createContext(display, config, EGL_NO_CONTEXT, kAttributes.data());
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
    const bool isEs = candidate.driver == Driver::gles;
    if (!egl.bindApi(isEs ? EGL_OPENGL_ES_API : EGL_OPENGL_API))
        return isEs ? "it has no OpenGL ES" : "it has OpenGL ES only";
    EGLConfig config = nullptr;
    if (!listHas(extensions, "EGL_KHR_no_config_context") &&
        !listHas(extensions, "EGL_MESA_configless_context")) {
        config = anyConfig(egl, display, isEs);
        if (!config) return "it has no config for OpenGL";
    }
    // With Mesa, robust access costs nothing that can be measured: a software rasteriser checks every access
    // anyway. It has not been measured with other drivers.
    const bool isEgl15 = major > 1 || minor >= 5;
    const Care care{.robust = isEgl15 && candidate.platform == EGL_PLATFORM_SURFACELESS_MESA &&
                              listHas(extensions, "EGL_EXT_create_context_robustness"),
                    .notifies = isEgl15 || listHas(extensions, "EGL_KHR_create_context")};
    EGLContext context =
        isEs ? esContext(egl, display, config) : bestContext(egl, display, config, debug, care);
    if (context == EGL_NO_CONTEXT)
        return fmt::format("no {} context ({})", isEs ? "OpenGL ES 3.0" : "OpenGL 4.1 core", egl.lastError());
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

Attempt openSurfaceless(const ContextOptions& options, Driver driver) {
    const auto opened = openEglLibrary(options.eglLibrary);
    if (const std::string* why = std::get_if<std::string>(&opened))
        return std::vector<std::string>{"EGL without a surface: " + *why};
    const auto& egl = std::get<EglLibrary>(opened);
    if (!egl.getPlatformDisplay || !egl.hasClientExtension("EGL_MESA_platform_surfaceless"))
        return std::vector<std::string>{"EGL without a surface: " + egl.name +
                                        " has no EGL_MESA_platform_surfaceless"};
    return tryAll(egl, {{EGL_PLATFORM_SURFACELESS_MESA, nullptr, driver, "EGL without a surface"}},
                  options.debugContext);
}

Attempt openEglSurfaceless(const ContextOptions& options) {
    return openSurfaceless(options, Driver::egl);
}

Attempt openEs(const ContextOptions& options) {
    return openSurfaceless(options, Driver::gles);
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

constexpr ContextWay kWays[] = {{Driver::egl, openEglSurfaceless},
                                {Driver::eglDevice, openEglDevice},
                                {Driver::osmesa, openOsmesa},
                                {Driver::gles, openEs}};

}  // namespace

std::span<const ContextWay> contextWays() {
    return kWays;
}

std::string_view adviceWithoutDriver() {
    return "Mesa draws without a graphics card (on Debian and Ubuntu: libegl1 libgl1-mesa-dri)";
}

}  // namespace glibra::gpu
