#include "gpu/context/es_functions.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

namespace glibra::gpu {
namespace {

// What the driver's own functions are, where the table has others.
struct Own {
    PFNGLENABLEPROC enable = nullptr;
    PFNGLDISABLEPROC disable = nullptr;
    PFNGLISENABLEDPROC isEnabled = nullptr;
    PFNGLUSEPROGRAMPROC useProgram = nullptr;
    PFNGLDELETEPROGRAMPROC deleteProgram = nullptr;
    PFNGLGETERRORPROC getError = nullptr;
};
Own ownFunctions;
GLuint program = 0;            ///< in use
GLenum pending = GL_NO_ERROR;  ///< of a function that ES does not have
bool isLoaded = false;
bool hasWide = false;      ///< EXT_texture_norm16
bool clampsDepth = false;  ///< EXT_depth_clamp

// ---- States

/// Others are always on, always off, or of the vertex stage.
bool isOfEs(GLenum capability) {
    switch (capability) {
        case GL_BLEND:
        case GL_CULL_FACE:
        case GL_DEPTH_TEST:
        case GL_DITHER:
        case GL_POLYGON_OFFSET_FILL:
        case GL_PRIMITIVE_RESTART_FIXED_INDEX:
        case GL_RASTERIZER_DISCARD:
        case GL_SAMPLE_ALPHA_TO_COVERAGE:
        case GL_SCISSOR_TEST:
        case GL_STENCIL_TEST:
            return true;
        case GL_DEPTH_CLAMP:
            return clampsDepth;
        default:
            return false;
    }
}

/// The index that restarts is the largest one, as glibra sets it.
GLenum ofEs(GLenum capability) {
    return capability == GL_PRIMITIVE_RESTART ? GL_PRIMITIVE_RESTART_FIXED_INDEX : capability;
}

void enable(GLenum capability) {
    if (isOfEs(ofEs(capability))) ownFunctions.enable(ofEs(capability));
}
void disable(GLenum capability) {
    if (isOfEs(ofEs(capability))) ownFunctions.disable(ofEs(capability));
}
GLboolean isEnabled(GLenum capability) {
    if (isOfEs(ofEs(capability))) return ownFunctions.isEnabled(ofEs(capability));
    return GL_FALSE;
}

void depthRange(GLdouble nearest, GLdouble farthest) {
    glad_glDepthRangef(static_cast<GLfloat>(nearest), static_cast<GLfloat>(farthest));
}

// ---- Framebuffers and textures

void drawBuffer(GLenum buffer) {
    std::array<GLenum, 8> outputs{};
    const std::size_t index = buffer == GL_NONE ? 0 : std::min<std::size_t>(buffer - GL_COLOR_ATTACHMENT0, 7);
    outputs[index] = buffer;
    glad_glDrawBuffers(static_cast<GLsizei>(index + 1), outputs.data());
}

void framebufferTexture1D(GLenum target, GLenum point, GLenum, GLuint texture, GLint level) {
    glad_glFramebufferTexture2D(target, point, GL_TEXTURE_2D, texture, level);
}

void texStorage1D(GLenum target, GLsizei levels, GLenum format, GLsizei width) {
    glad_glTexStorage2D(target, levels, format, width, 1);
}

void texSubImage1D(GLenum target, GLint level, GLint x, GLsizei width, GLenum format, GLenum type,
                   const void* texels) {
    glad_glTexSubImage2D(target, level, x, 0, width, 1, format, type, texels);
}

void getBufferSubData(GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
    const void* mapped = glad_glMapBufferRange(target, offset, size, GL_MAP_READ_BIT);
    if (mapped == nullptr) return;
    std::copy_n(static_cast<const std::byte*>(mapped), size, static_cast<std::byte*>(data));
    glad_glUnmapBuffer(target);
}

// ---- Programs

void useProgram(GLuint used) {
    program = used;
    ownFunctions.useProgram(used);
}

/// Its number may be that of another program from now on.
void deleteProgram(GLuint deleted) {
    if (deleted == program) useProgram(0);
    ownFunctions.deleteProgram(deleted);
}

/// Sets a uniform of a program that need not be in use.
template <auto& kUniform, class... Arguments>
void programUniform(GLuint of, GLint location, Arguments... arguments) {
    if (of != program) ownFunctions.useProgram(of);
    kUniform(location, arguments...);
    if (of != program) ownFunctions.useProgram(program);
}

// ---- The table

GLenum getError() {
    const GLenum noted = std::exchange(pending, GL_NO_ERROR);
    return noted != GL_NO_ERROR ? noted : ownFunctions.getError();
}

/// In place of a function that ES does not have.
template <auto& kFunction, class = std::remove_cvref_t<decltype(kFunction)>>
struct Missing;
template <auto& kFunction, class Returned, class... Arguments>
struct Missing<kFunction, Returned (*)(Arguments...)> {
    static Returned refuse(Arguments...) {
        pending = GL_INVALID_OPERATION;
        return Returned();
    }
    /// What it would set has one value in ES, or is set in another way.
    static Returned ignore(Arguments...) { return Returned(); }
};

void setMissing() {
#define GLIBRA_REFUSED(name) glad_gl##name = Missing<glad_gl##name>::refuse;
    GLIBRA_REFUSED(FramebufferTexture)
    GLIBRA_REFUSED(TexBuffer)
    GLIBRA_REFUSED(GetTexImage)
    GLIBRA_REFUSED(GetTexLevelParameteriv)
    GLIBRA_REFUSED(TexImage1D)
    GLIBRA_REFUSED(TexImage2DMultisample)
    GLIBRA_REFUSED(TexImage3DMultisample)
    GLIBRA_REFUSED(DrawArraysIndirect)
    GLIBRA_REFUSED(DrawElementsIndirect)
    GLIBRA_REFUSED(GetUniformdv)
    GLIBRA_REFUSED(GetQueryiv)
    GLIBRA_REFUSED(GetQueryObjectiv)
    GLIBRA_REFUSED(GetQueryObjectui64v)
#undef GLIBRA_REFUSED
#define GLIBRA_IGNORED(name) glad_gl##name = Missing<glad_gl##name>::ignore;
    GLIBRA_IGNORED(BindFragDataLocation)
    GLIBRA_IGNORED(ClampColor)
    GLIBRA_IGNORED(EndConditionalRender)
    GLIBRA_IGNORED(MinSampleShading)
    GLIBRA_IGNORED(PatchParameterfv)
    GLIBRA_IGNORED(PatchParameteri)
    GLIBRA_IGNORED(PointParameterf)
    GLIBRA_IGNORED(PointParameteri)
    GLIBRA_IGNORED(PointSize)
    GLIBRA_IGNORED(PolygonMode)
    GLIBRA_IGNORED(PrimitiveRestartIndex)
    GLIBRA_IGNORED(ProvokingVertex)
    GLIBRA_IGNORED(SamplerParameterfv)
#undef GLIBRA_IGNORED
    for (auto* each : {&glad_glEnablei, &glad_glDisablei})
        if (*each == nullptr) *each = Missing<glad_glEnablei>::refuse;
    if (glad_glColorMaski == nullptr) glad_glColorMaski = Missing<glad_glColorMaski>::refuse;
    if (glad_glBlendFuncSeparatei == nullptr)
        glad_glBlendFuncSeparatei = Missing<glad_glBlendFuncSeparatei>::refuse;
    if (glad_glBlendEquationSeparatei == nullptr)
        glad_glBlendEquationSeparatei = Missing<glad_glBlendEquationSeparatei>::refuse;
}

void setProgramUniforms() {
#define GLIBRA_UNIFORM(name) glad_glProgramUniform##name = programUniform<glad_glUniform##name>;
#define GLIBRA_UNIFORMS(size) \
    GLIBRA_UNIFORM(size##fv)  \
    GLIBRA_UNIFORM(size##iv)  \
    GLIBRA_UNIFORM(size##uiv)
    GLIBRA_UNIFORMS(1)
    GLIBRA_UNIFORMS(2)
    GLIBRA_UNIFORMS(3)
    GLIBRA_UNIFORMS(4)
    GLIBRA_UNIFORM(Matrix2fv)
    GLIBRA_UNIFORM(Matrix2x3fv)
    GLIBRA_UNIFORM(Matrix2x4fv)
    GLIBRA_UNIFORM(Matrix3fv)
    GLIBRA_UNIFORM(Matrix3x2fv)
    GLIBRA_UNIFORM(Matrix3x4fv)
    GLIBRA_UNIFORM(Matrix4fv)
    GLIBRA_UNIFORM(Matrix4x2fv)
    GLIBRA_UNIFORM(Matrix4x3fv)
#undef GLIBRA_UNIFORMS
#undef GLIBRA_UNIFORM
}

bool hasExtension(std::string_view name) {
    GLint count = 0;
    glad_glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(std::max(count, 0)); ++i)
        if (const auto* each = reinterpret_cast<const char*>(glad_glGetStringi(GL_EXTENSIONS, i));
            each != nullptr && each == name)
            return true;
    return false;
}

}  // namespace

bool isEs() {
    return isLoaded;
}

bool hasWideTexels() {
    return hasWide;
}

void leaveEs() {
    isLoaded = false;
}

bool loadEsFunctions(const std::function<void*(const char*)>& address) {
    bool isWhole = true;
#define GLIBRA_ES_FUNCTION(name)                                                    \
    glad_gl##name = reinterpret_cast<decltype(glad_gl##name)>(address("gl" #name)); \
    isWhole = isWhole && (glad_gl##name != nullptr || isOptional("gl" #name));
    const auto isOptional = [](std::string_view name) {
        constexpr std::array<std::string_view, 10> kOptional{"glEnablei",
                                                             "glDisablei",
                                                             "glClipControl",
                                                             "glColorMaski",
                                                             "glBlendFuncSeparatei",
                                                             "glBlendEquationSeparatei",
                                                             "glMapBufferRange",
                                                             "glUnmapBuffer",
                                                             "glProgramParameteri",
                                                             "glGetInternalformativ"};
        return std::ranges::find(kOptional, name) != kOptional.end();
    };
#include "gpu/context/es_functions.def"
    if (!isWhole) return false;
    // Nothing of later versions is there, whatever the loader finds.
    GLAD_GL_VERSION_4_1 = 1;
    GLAD_GL_VERSION_4_2 = GLAD_GL_VERSION_4_3 = GLAD_GL_VERSION_4_4 = GLAD_GL_VERSION_4_5 =
        GLAD_GL_VERSION_4_6 = 0;
    ownFunctions = {glad_glEnable,     glad_glDisable,       glad_glIsEnabled,
                    glad_glUseProgram, glad_glDeleteProgram, glad_glGetError};
    glad_glEnable = enable;
    glad_glDisable = disable;
    glad_glIsEnabled = isEnabled;
    glad_glUseProgram = useProgram;
    glad_glDeleteProgram = deleteProgram;
    glad_glGetError = getError;
    glad_glDepthRange = depthRange;
    glad_glDrawBuffer = drawBuffer;
    glad_glFramebufferTexture1D = framebufferTexture1D;
    glad_glTexStorage1D = texStorage1D;
    glad_glTexSubImage1D = texSubImage1D;
    glad_glGetBufferSubData = getBufferSubData;
    if (glad_glMapBufferRange == nullptr)
        glad_glGetBufferSubData = reinterpret_cast<PFNGLGETBUFFERSUBDATAPROC>(address("glGetBufferSubData"));
    if (void* clipControl = address("glClipControlEXT"))  // pages know it without the suffix
        glad_glClipControl = reinterpret_cast<PFNGLCLIPCONTROLPROC>(clipControl);
    setMissing();
    setProgramUniforms();
    program = 0;
    pending = GL_NO_ERROR;
    clampsDepth = hasExtension("GL_EXT_depth_clamp");
    hasWide = hasExtension("GL_EXT_texture_norm16");
    isLoaded = true;
    return true;
}

}  // namespace glibra::gpu
