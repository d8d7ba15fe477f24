#include "compatibility_context.h"

#include <dlfcn.h>
#include <glad/egl.h>
#include <glad/gl.h>

#include <array>
#include <stdexcept>
#include <string>

namespace glibra::oracle {

struct CompatibilityContext::Egl {
    PFNEGLGETPROCADDRESSPROC getProcAddress = nullptr;
    PFNEGLMAKECURRENTPROC makeCurrent = nullptr;
    PFNEGLGETCURRENTCONTEXTPROC getCurrentContext = nullptr;
    PFNEGLCREATECONTEXTPROC createContext = nullptr;
    PFNEGLDESTROYCONTEXTPROC destroyContext = nullptr;
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    bool use(EGLContext which) const {
        return makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, which) == EGL_TRUE;
    }
};

CompatibilityContext::CompatibilityContext()
    : egl_(std::make_unique<Egl>()), functions_(std::make_unique<GladGLContext>()) {
    // It is never closed, because drivers crash when they are unloaded.
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error("the oracle needs libEGL.so.1");
    const auto function = [&]<class F>(F& pointer, const char* name) {
        pointer = reinterpret_cast<F>(dlsym(library, name));
        if (!pointer) throw std::runtime_error(std::string("libEGL.so.1 lacks ") + name);
    };
    PFNEGLINITIALIZEPROC initialize = nullptr;
    PFNEGLBINDAPIPROC bindApi = nullptr;
    PFNEGLGETPLATFORMDISPLAYPROC getPlatformDisplay = nullptr;
    function(egl_->getProcAddress, "eglGetProcAddress");
    function(egl_->makeCurrent, "eglMakeCurrent");
    function(egl_->getCurrentContext, "eglGetCurrentContext");
    function(egl_->createContext, "eglCreateContext");
    function(egl_->destroyContext, "eglDestroyContext");
    function(initialize, "eglInitialize");
    function(bindApi, "eglBindAPI");
    function(getPlatformDisplay, "eglGetPlatformDisplay");

    egl_->display = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (egl_->display == EGL_NO_DISPLAY || !initialize(egl_->display, nullptr, nullptr) ||
        !bindApi(EGL_OPENGL_API))
        throw std::runtime_error("the oracle needs Mesa's EGL without a surface");
    for (EGLint minor = 6; minor >= 3 && egl_->context == EGL_NO_CONTEXT; --minor) {
        const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               minor,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                               EGL_NONE};
        egl_->context = egl_->createContext(egl_->display, nullptr, EGL_NO_CONTEXT, attributes.data());
    }
    if (egl_->context == EGL_NO_CONTEXT)
        throw std::runtime_error("the oracle needs a driver with a compatibility profile of 4.3 or later");

    const Current current(*this);
    const auto load = [](void* getProcAddress, const char* name) {
        return reinterpret_cast<PFNEGLGETPROCADDRESSPROC>(getProcAddress)(name);
    };
    if (!gladLoadGLContextUserPtr(functions_.get(), load, reinterpret_cast<void*>(egl_->getProcAddress)))
        throw std::runtime_error("the oracle found no GL functions");
}

CompatibilityContext::~CompatibilityContext() {
    egl_->destroyContext(egl_->display, egl_->context);
}

CompatibilityContext::Current::Current(const CompatibilityContext& context)
    : context_(context), before_(context.egl_->getCurrentContext()) {
    if (!context_.egl_->use(context_.egl_->context))
        throw std::runtime_error("the oracle's context cannot be made current");
}

CompatibilityContext::Current::~Current() {
    context_.egl_->use(before_);
}

}  // namespace glibra::oracle
