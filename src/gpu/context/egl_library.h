#pragma once
// The EGL functions that opening a context needs, resolved at run time. Internal to this room.

#include <glad/egl.h>

#include <string>
#include <string_view>
#include <variant>

namespace glibra::gpu {

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
bool listHas(std::string_view list, std::string_view word);

/// Opens the library of that name; a text says why it cannot be used.
std::variant<EglLibrary, std::string> openEglLibrary(const std::string& name);

}  // namespace glibra::gpu
