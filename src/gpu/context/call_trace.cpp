#include "gpu/context/call_trace.h"

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

CallTrace* activeTrace() {
    return trace;
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

}  // namespace glibra::gpu
