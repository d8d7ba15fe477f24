#include "gpu/context/egl_library.h"

#include <array>
#include <utility>

#include "gpu/context/library.h"

namespace glibra::gpu {

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

std::variant<EglLibrary, std::string> openEglLibrary(const std::string& name) {
    auto opened = Library::open(name);
    if (const std::string* why = std::get_if<std::string>(&opened)) return *why;
    const Library& library = std::get<Library>(opened);

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

}  // namespace glibra::gpu
