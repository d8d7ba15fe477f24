#include "gpu/context/call_counter.h"

#include <fmt/format.h>
#include <glad/gl.h>
#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace glibra::gpu {
namespace {

/// There is one for the process, as of CallCounter.
CallTrace* trace = nullptr;

/// What the arguments of a function are, one letter each: i and u numbers, b a truth, e a word of GL, m a
/// kind of primitives, x bits, l a size or offset of bytes, f a float, p an address.
struct Signature {
    std::string_view name, arguments;
};
constexpr Signature kSignatures[] = {
    {"glActiveTexture", "e"},
    {"glBindBuffer", "eu"},
    {"glBindBufferBase", "euu"},
    {"glBindBufferRange", "euull"},
    {"glBindFramebuffer", "eu"},
    {"glBindImageTexture", "uuibiee"},
    {"glBindSampler", "uu"},
    {"glBindTexture", "eu"},
    {"glBindTextureUnit", "uu"},
    {"glBindVertexArray", "u"},
    {"glBlendColor", "ffff"},
    {"glBlendEquationSeparate", "ee"},
    {"glBlendFuncSeparate", "eeee"},
    {"glBlitFramebuffer", "iiiiiiiixe"},
    {"glBufferSubData", "ellp"},
    {"glClear", "x"},
    {"glClearBufferfi", "eifi"},
    {"glClearBufferfv", "eip"},
    {"glClearBufferiv", "eip"},
    {"glClearBufferuiv", "eip"},
    {"glClipControl", "ee"},
    {"glColorMask", "bbbb"},
    {"glColorMaski", "ubbbb"},
    {"glCullFace", "e"},
    {"glDepthFunc", "e"},
    {"glDepthMask", "b"},
    {"glDisable", "e"},
    {"glDisablei", "eu"},
    {"glDispatchCompute", "uuu"},
    {"glDispatchComputeIndirect", "l"},
    {"glDrawArrays", "mii"},
    {"glDrawArraysIndirect", "mp"},
    {"glDrawArraysInstanced", "miii"},
    {"glDrawBuffers", "ip"},
    {"glDrawElements", "miep"},
    {"glDrawElementsIndirect", "mep"},
    {"glDrawElementsInstanced", "miepi"},
    {"glEnable", "e"},
    {"glEnablei", "eu"},
    {"glFrontFace", "e"},
    {"glGenerateMipmap", "e"},
    {"glLineWidth", "f"},
    {"glMemoryBarrier", "x"},
    {"glPatchParameteri", "ei"},
    {"glPointSize", "f"},
    {"glPolygonMode", "ee"},
    {"glPolygonOffset", "ff"},
    {"glProvokingVertex", "e"},
    {"glReadPixels", "iiiieep"},
    {"glScissor", "iiii"},
    {"glStencilFuncSeparate", "eeix"},
    {"glStencilMaskSeparate", "ex"},
    {"glStencilOpSeparate", "eeee"},
    {"glUniform1f", "if"},
    {"glUniform1fv", "iip"},
    {"glUniform1i", "ii"},
    {"glUniform1iv", "iip"},
    {"glUniform2f", "iff"},
    {"glUniform2fv", "iip"},
    {"glUniform3f", "ifff"},
    {"glUniform3fv", "iip"},
    {"glUniform4f", "iffff"},
    {"glUniform4fv", "iip"},
    {"glUniformBlockBinding", "uuu"},
    {"glUniformMatrix3fv", "iibp"},
    {"glUniformMatrix4fv", "iibp"},
    {"glUseProgram", "u"},
    {"glVertexAttrib1f", "uf"},
    {"glVertexAttrib4f", "uffff"},
    {"glViewport", "iiii"},
};

struct TracedWord {
    GLenum value;
    const char* name;
};
constexpr TracedWord kTracedWords[] = {
    {GL_ARRAY_BUFFER, "GL_ARRAY_BUFFER"},
    {GL_ATOMIC_COUNTER_BUFFER, "GL_ATOMIC_COUNTER_BUFFER"},
    {GL_BACK, "GL_BACK"},
    {GL_BLEND, "GL_BLEND"},
    {GL_CCW, "GL_CCW"},
    {GL_COLOR, "GL_COLOR"},
    {GL_CULL_FACE, "GL_CULL_FACE"},
    {GL_CW, "GL_CW"},
    {GL_DEPTH, "GL_DEPTH"},
    {GL_DEPTH_CLAMP, "GL_DEPTH_CLAMP"},
    {GL_DEPTH_STENCIL, "GL_DEPTH_STENCIL"},
    {GL_DEPTH_TEST, "GL_DEPTH_TEST"},
    {GL_DRAW_FRAMEBUFFER, "GL_DRAW_FRAMEBUFFER"},
    {GL_DRAW_INDIRECT_BUFFER, "GL_DRAW_INDIRECT_BUFFER"},
    {GL_ELEMENT_ARRAY_BUFFER, "GL_ELEMENT_ARRAY_BUFFER"},
    {GL_FILL, "GL_FILL"},
    {GL_FLOAT, "GL_FLOAT"},
    {GL_FRAMEBUFFER, "GL_FRAMEBUFFER"},
    {GL_FRAMEBUFFER_SRGB, "GL_FRAMEBUFFER_SRGB"},
    {GL_FRONT, "GL_FRONT"},
    {GL_FRONT_AND_BACK, "GL_FRONT_AND_BACK"},
    {GL_LEQUAL, "GL_LEQUAL"},
    {GL_LESS, "GL_LESS"},
    {GL_LINE, "GL_LINE"},
    {GL_LINEAR, "GL_LINEAR"},
    {GL_MULTISAMPLE, "GL_MULTISAMPLE"},
    {GL_NEAREST, "GL_NEAREST"},
    {GL_ONE_MINUS_SRC_ALPHA, "GL_ONE_MINUS_SRC_ALPHA"},
    {GL_PATCH_VERTICES, "GL_PATCH_VERTICES"},
    {GL_PIXEL_PACK_BUFFER, "GL_PIXEL_PACK_BUFFER"},
    {GL_POLYGON_OFFSET_FILL, "GL_POLYGON_OFFSET_FILL"},
    {GL_PROGRAM_POINT_SIZE, "GL_PROGRAM_POINT_SIZE"},
    {GL_READ_FRAMEBUFFER, "GL_READ_FRAMEBUFFER"},
    {GL_RGB, "GL_RGB"},
    {GL_RGBA, "GL_RGBA"},
    {GL_SCISSOR_TEST, "GL_SCISSOR_TEST"},
    {GL_SHADER_STORAGE_BUFFER, "GL_SHADER_STORAGE_BUFFER"},
    {GL_SRC_ALPHA, "GL_SRC_ALPHA"},
    {GL_STENCIL, "GL_STENCIL"},
    {GL_STENCIL_TEST, "GL_STENCIL_TEST"},
    {GL_TEXTURE_1D, "GL_TEXTURE_1D"},
    {GL_TEXTURE_1D_ARRAY, "GL_TEXTURE_1D_ARRAY"},
    {GL_TEXTURE_2D, "GL_TEXTURE_2D"},
    {GL_TEXTURE_2D_ARRAY, "GL_TEXTURE_2D_ARRAY"},
    {GL_TEXTURE_2D_MULTISAMPLE, "GL_TEXTURE_2D_MULTISAMPLE"},
    {GL_TEXTURE_3D, "GL_TEXTURE_3D"},
    {GL_TEXTURE_BUFFER, "GL_TEXTURE_BUFFER"},
    {GL_TEXTURE_CUBE_MAP, "GL_TEXTURE_CUBE_MAP"},
    {GL_TEXTURE_RECTANGLE, "GL_TEXTURE_RECTANGLE"},
    {GL_UNIFORM_BUFFER, "GL_UNIFORM_BUFFER"},
    {GL_UNSIGNED_BYTE, "GL_UNSIGNED_BYTE"},
    {GL_UNSIGNED_INT, "GL_UNSIGNED_INT"},
};
constexpr TracedWord kTracedModes[] = {
    {GL_POINTS, "GL_POINTS"},
    {GL_LINES, "GL_LINES"},
    {GL_LINE_LOOP, "GL_LINE_LOOP"},
    {GL_LINE_STRIP, "GL_LINE_STRIP"},
    {GL_TRIANGLES, "GL_TRIANGLES"},
    {GL_TRIANGLE_STRIP, "GL_TRIANGLE_STRIP"},
    {GL_TRIANGLE_FAN, "GL_TRIANGLE_FAN"},
    {GL_LINES_ADJACENCY, "GL_LINES_ADJACENCY"},
    {GL_LINE_STRIP_ADJACENCY, "GL_LINE_STRIP_ADJACENCY"},
    {GL_TRIANGLES_ADJACENCY, "GL_TRIANGLES_ADJACENCY"},
    {GL_TRIANGLE_STRIP_ADJACENCY, "GL_TRIANGLE_STRIP_ADJACENCY"},
    {GL_PATCHES, "GL_PATCHES"},
};

/// GL's name of a word. Some share their value with a small number; texture units count on.
template <class Words>
std::string nameOf(const Words& words, GLenum value) {
    for (const TracedWord& each : words)
        if (each.value == value) return each.name;
    constexpr GLenum kMostUnits = 192;
    if (value >= GL_TEXTURE0 && value < GL_TEXTURE0 + kMostUnits)
        return fmt::format("GL_TEXTURE{}", value - GL_TEXTURE0);
    return fmt::format("{:#06x}", value);
}

std::string nextArgument(char kind, CallArguments& arguments) {
    switch (kind) {
        case 'i':
            return fmt::format("{}", va_arg(arguments.list, GLint));
        case 'u':
            return fmt::format("{}", va_arg(arguments.list, GLuint));
        case 'b':
            return va_arg(arguments.list, int) != 0 ? "GL_TRUE" : "GL_FALSE";
        case 'e':
            return nameOf(kTracedWords, va_arg(arguments.list, GLenum));
        case 'm':
            return nameOf(kTracedModes, va_arg(arguments.list, GLenum));
        case 'x':
            return fmt::format("{:#x}", va_arg(arguments.list, GLuint));
        case 'l':
            return fmt::format("{}", va_arg(arguments.list, GLintptr));
        case 'f':
            return fmt::format("{:.6g}", va_arg(arguments.list, double));
        default:
            break;
    }
    static_cast<void>(va_arg(arguments.list, const void*));
    return "...";
}

}  // namespace

CallTrace::CallTrace(const WorkPlaces& places) : places_(places) {
    trace = this;
}

CallTrace::~CallTrace() {
    trace = nullptr;
}

void CallTrace::add(const char* name, int argumentCount, CallArguments& arguments) {
    const auto* const known = std::find_if(std::begin(kSignatures), std::end(kSignatures),
                                           [&](const Signature& each) { return each.name == name; });
    std::string text = std::string(name) + "(";
    if (known != std::end(kSignatures) &&
        known->arguments.size() == static_cast<std::size_t>(argumentCount)) {
        for (std::size_t i = 0; i < known->arguments.size(); ++i)
            text += (i > 0 ? ", " : "") + nextArgument(known->arguments[i], arguments);
    } else if (argumentCount > 0) {
        text += "...";
    }
    text += ")";
    if (!calls_.empty() && calls_.back().text == text && calls_.back().place == places_.current()) {
        ++calls_.back().times;
        return;
    }
    calls_.push_back({places_.current(), std::move(text)});
}

std::string CallTrace::text() const {
    std::string all;
    const Place* place = nullptr;
    for (const Call& each : calls_) {
        if (place == nullptr || *place != each.place)
            all += each.place.file.empty() ? std::string("before the first statement\n")
                                           : fmt::format("{}:{}\n", each.place.file, each.place.line);
        place = &each.place;
        all += "  " + each.text;
        if (each.times > 1) all += fmt::format(" x {}", each.times);
        all += "\n";
    }
    return all;
}

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
    if (trace != nullptr) {
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
