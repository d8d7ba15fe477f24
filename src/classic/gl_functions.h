#pragma once
// The GL functions that the classes call, of the context that the calling program made current. They are
// found anew for each kind of context, apart from glad's one table of the process, which the renderers use.

#include <glad/gl.h>

#include <set>
#include <string>
#include <string_view>

namespace glibra::classic {

// X(pointer type, name without gl)
#define GLIBRA_CLASSIC_GL(X)                                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                         \
    X(PFNGLBINDATTRIBLOCATIONPROC, BindAttribLocation)             \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                             \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                   \
    X(PFNGLBUFFERDATAPROC, BufferData)                             \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                       \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                       \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                       \
    X(PFNGLCREATESHADERPROC, CreateShader)                         \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                       \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                       \
    X(PFNGLDELETESHADERPROC, DeleteShader)                         \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)             \
    X(PFNGLDISABLEPROC, Disable)                                   \
    X(PFNGLDISABLEVERTEXATTRIBARRAYPROC, DisableVertexAttribArray) \
    X(PFNGLDRAWELEMENTSINDIRECTPROC, DrawElementsIndirect)         \
    X(PFNGLDRAWELEMENTSINSTANCEDPROC, DrawElementsInstanced)       \
    X(PFNGLENABLEPROC, Enable)                                     \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)   \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                             \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                   \
    X(PFNGLGETACTIVEATTRIBPROC, GetActiveAttrib)                   \
    X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                 \
    X(PFNGLGETATTRIBLOCATIONPROC, GetAttribLocation)               \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                           \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)               \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                         \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                 \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                           \
    X(PFNGLGETSTRINGIPROC, GetStringi)                             \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)             \
    X(PFNGLISENABLEDPROC, IsEnabled)                               \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                           \
    X(PFNGLMULTIDRAWELEMENTSPROC, MultiDrawElements)               \
    X(PFNGLPATCHPARAMETERIPROC, PatchParameteri)                   \
    X(PFNGLPRIMITIVERESTARTINDEXPROC, PrimitiveRestartIndex)       \
    X(PFNGLPROGRAMUNIFORM1FVPROC, ProgramUniform1fv)               \
    X(PFNGLPROGRAMUNIFORM2FVPROC, ProgramUniform2fv)               \
    X(PFNGLPROGRAMUNIFORM3FVPROC, ProgramUniform3fv)               \
    X(PFNGLPROGRAMUNIFORM4FVPROC, ProgramUniform4fv)               \
    X(PFNGLPROGRAMUNIFORM1IVPROC, ProgramUniform1iv)               \
    X(PFNGLPROGRAMUNIFORM2IVPROC, ProgramUniform2iv)               \
    X(PFNGLPROGRAMUNIFORM3IVPROC, ProgramUniform3iv)               \
    X(PFNGLPROGRAMUNIFORM4IVPROC, ProgramUniform4iv)               \
    X(PFNGLPROGRAMUNIFORM1UIVPROC, ProgramUniform1uiv)             \
    X(PFNGLPROGRAMUNIFORM2UIVPROC, ProgramUniform2uiv)             \
    X(PFNGLPROGRAMUNIFORM3UIVPROC, ProgramUniform3uiv)             \
    X(PFNGLPROGRAMUNIFORM4UIVPROC, ProgramUniform4uiv)             \
    X(PFNGLPROGRAMUNIFORMMATRIX2FVPROC, ProgramUniformMatrix2fv)   \
    X(PFNGLPROGRAMUNIFORMMATRIX3FVPROC, ProgramUniformMatrix3fv)   \
    X(PFNGLPROGRAMUNIFORMMATRIX4FVPROC, ProgramUniformMatrix4fv)   \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                         \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                             \
    X(PFNGLVERTEXATTRIB4FVPROC, VertexAttrib4fv)                   \
    X(PFNGLVERTEXATTRIBI4IVPROC, VertexAttribI4iv)                 \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)

struct Gl {
#define GLIBRA_CLASSIC_MEMBER(type, name) type name = nullptr;
    GLIBRA_CLASSIC_GL(GLIBRA_CLASSIC_MEMBER)
#undef GLIBRA_CLASSIC_MEMBER
    PFNGLMULTIDRAWELEMENTSINDIRECTPROC MultiDrawElementsIndirect = nullptr;  ///< null before OpenGL 4.3
    int version = 0;                                                         ///< 45 is OpenGL 4.5
    std::set<std::string, std::less<>> extensions;
    void* (*currentHandle)() = nullptr;

    [[nodiscard]] GLint number(GLenum name) const;
};

/// The functions of the context that is current on this thread. Null if there is none of OpenGL 4.1 or later;
/// `who` is then told so on standard error. The functions stay until the process ends.
const Gl* glOfThread(const char* who);

/// One line on standard error: "glibra: WHO: TEXT".
void complainOf(std::string_view who, std::string_view text);

/// GL names that live in one context. They are deleted only where that context is current: a program may have
/// ended it before.
class Owner {
  public:
    /// Finds the functions; false, with a message, if no context is current.
    bool open(const char* who);
    [[nodiscard]] const Gl* gl() const { return gl_; }
    [[nodiscard]] bool isCurrent() const { return gl_ != nullptr && gl_->currentHandle() == context_; }
    [[nodiscard]] void* context() const { return context_; }

  private:
    const Gl* gl_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace glibra::classic
