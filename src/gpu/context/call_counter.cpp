#include "gpu/context/call_counter.h"

#include <glad/gl.h>

#include <cstdarg>
#include <utility>

#include "gpu/context/call_trace.h"

namespace glibra::gpu {
namespace {

/// There is one for the process, like the table of GL functions that it watches: glad's callbacks carry no
/// context.
CallCounts* active = nullptr;

std::uint64_t componentsOf(GLenum format) {
    switch (format) {
        case GL_RED:
            return 1;
        case GL_RG:
            return 2;
        case GL_RGB:
            return 3;
        default:
            return 4;
    }
}

std::uint64_t bytesOf(GLenum type) {
    switch (type) {
        case GL_UNSIGNED_BYTE:
        case GL_BYTE:
            return 1;
        case GL_UNSIGNED_SHORT:
        case GL_HALF_FLOAT:
            return 2;
        default:
            return 4;
    }
}

/// The arguments of glTexSubImageND from `offsets` on: offsets, sizes, format, type.
std::uint64_t texelBytes(va_list arguments, int dimensions) {
    static_cast<void>(va_arg(arguments, GLenum));
    static_cast<void>(va_arg(arguments, GLint));
    for (int i = 0; i < dimensions; ++i) static_cast<void>(va_arg(arguments, GLint));
    std::uint64_t texels = 1;
    for (int i = 0; i < dimensions; ++i) texels *= static_cast<std::uint64_t>(va_arg(arguments, GLsizei));
    const auto format = va_arg(arguments, GLenum);
    const auto type = va_arg(arguments, GLenum);
    return texels * componentsOf(format) * bytesOf(type);
}

std::uint64_t pixelsOf(va_list arguments) {
    static_cast<void>(va_arg(arguments, GLint));
    static_cast<void>(va_arg(arguments, GLint));
    const auto width = va_arg(arguments, GLsizei);
    const auto height = va_arg(arguments, GLsizei);
    return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
}

template <class Function>
bool is(GLADapiproc called, Function function) {
    return called == reinterpret_cast<GLADapiproc>(function);
}

void count(const char* name, GLADapiproc called, int argumentCount, ...) {
    if (active == nullptr) return;
    ++active->calls;
    va_list arguments;
    if (CallTrace* trace = activeTrace()) {
        CallArguments traced;
        va_start(traced.list, argumentCount);
        trace->add(name, argumentCount, traced);
        va_end(traced.list);
    }
    va_start(arguments, argumentCount);
    if (is(called, glad_glDrawElements) || is(called, glad_glDrawArrays) ||
        is(called, glad_glDrawElementsInstanced) || is(called, glad_glDrawArraysInstanced) ||
        is(called, glad_glDrawElementsIndirect) || is(called, glad_glDrawArraysIndirect)) {
        ++active->draws;
    } else if (is(called, glad_glLinkProgram)) {
        ++active->programsLinked;
    } else if (is(called, glad_glTexSubImage1D) || is(called, glad_glTexSubImage2D) ||
               is(called, glad_glTexSubImage3D)) {
        ++active->texturesFilled;
        const int dimensions = is(called, glad_glTexSubImage1D)   ? 1
                               : is(called, glad_glTexSubImage2D) ? 2
                                                                  : 3;
        active->bytesUploaded += texelBytes(arguments, dimensions);
    } else if (is(called, glad_glBufferData)) {
        static_cast<void>(va_arg(arguments, GLenum));
        const auto bytes = va_arg(arguments, GLsizeiptr);
        if (va_arg(arguments, const void*) != nullptr) {
            ++active->buffersFilled;
            active->bytesUploaded += static_cast<std::uint64_t>(bytes);
        }
    } else if (is(called, glad_glBufferSubData)) {
        static_cast<void>(va_arg(arguments, GLenum));
        static_cast<void>(va_arg(arguments, GLintptr));
        ++active->buffersFilled;
        active->bytesUploaded += static_cast<std::uint64_t>(va_arg(arguments, GLsizeiptr));
    } else if (is(called, glad_glReadPixels)) {
        active->pixelsRead += pixelsOf(arguments);
    } else if (is(called, glad_glFenceSync)) {
        ++active->fences;
    }
    va_end(arguments);
}

/// Replaces glad's own callback, which queries the driver's error after each call.
void ignoreResult(void* /*result*/, const char* /*name*/, GLADapiproc /*called*/, int /*argumentCount*/,
                  ...) {}

}  // namespace

CallCounter::CallCounter() : outer_(std::exchange(active, &counts_)) {
    gladSetGLPreCallback(count);
    gladSetGLPostCallback(ignoreResult);
    gladInstallGLDebug();
}

CallCounter::~CallCounter() {
    active = outer_;
    if (active == nullptr) gladUninstallGLDebug();
}

bool isCounting() {
    return active != nullptr;
}

}  // namespace glibra::gpu
