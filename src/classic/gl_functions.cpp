#include "classic/gl_functions.h"

#include <fmt/format.h>

#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "gpu/context/fork.h"

namespace glibra::classic {
namespace {

std::unique_ptr<Gl> loaded(const gpu::CurrentContext& current) {
    auto gl = std::make_unique<Gl>();
    bool isWhole = true;
    const auto find = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(current.address(name));
        return function != nullptr;
    };
#define GLIBRA_CLASSIC_LOAD(name) isWhole = find(gl->name, "gl" #name) && isWhole;
    GLIBRA_CLASSIC_GL(GLIBRA_CLASSIC_LOAD)
#undef GLIBRA_CLASSIC_LOAD
    if (!isWhole) return nullptr;
    gl->version = 10 * gl->number(GL_MAJOR_VERSION) + gl->number(GL_MINOR_VERSION);
    if (gl->version < 41) return nullptr;
    if (gl->version >= 43) find(gl->MultiDrawElementsIndirect, "glMultiDrawElementsIndirect");
    const GLint count = gl->number(GL_NUM_EXTENSIONS);
    for (GLint i = 0; i < count; ++i)
        if (const GLubyte* name = gl->GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)))
            gl->extensions.emplace(reinterpret_cast<const char*>(name));
    gl->currentHandle = current.currentHandle;
    return gl;
}

}  // namespace

GLint Gl::number(GLenum name) const {
    GLint value = 0;
    GetIntegerv(name, &value);
    return value;
}

const Gl* glOfThread(const char* who) {
    if (gpu::isForked()) {
        complainOf(who, gpu::forkedText());
        return nullptr;
    }
    const auto current = gpu::currentContext();
    if (!current) {
        complainOf(who, "no OpenGL context is current on this thread; make the one of your window current");
        return nullptr;
    }
    gpu::noteDriver();
    // EGL and GLX give functions for all contexts. What differs is what a context can do.
    const auto number = reinterpret_cast<PFNGLGETINTEGERVPROC>(current->address("glGetIntegerv"));
    GLint major = 0;
    GLint minor = 0;
    if (number != nullptr) {
        number(GL_MAJOR_VERSION, &major);
        number(GL_MINOR_VERSION, &minor);
    }
    static std::mutex mutex;
    static std::map<std::pair<void*, int>, std::unique_ptr<Gl>> tables;
    const std::lock_guard<std::mutex> lock(mutex);
    auto& table = tables[{reinterpret_cast<void*>(current->address), 10 * major + minor}];
    if (!table) table = loaded(*current);
    if (!table)
        complainOf(who, fmt::format("the context is of OpenGL {}.{}; at least 4.1 is needed", major, minor));
    return table.get();
}

void complainOf(std::string_view who, std::string_view text) {
    std::fputs(fmt::format("glibra: {}: {}\n", who, text).c_str(), stderr);
}

bool Owner::open(const char* who) {
    gl_ = glOfThread(who);
    context_ = gl_ != nullptr ? gl_->currentHandle() : nullptr;
    return gl_ != nullptr;
}

}  // namespace glibra::classic
