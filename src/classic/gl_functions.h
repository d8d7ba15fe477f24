#pragma once
// The GL functions that the classes call, of the context that the calling program made current. They are
// found anew for each kind of context, apart from glad's one table of the process, which the renderers use.

#include <glad/gl.h>

#include <set>
#include <string>
#include <string_view>

#include "gpu/context/fork.h"

namespace glibra::classic {

// X(name without gl)
// clang-format off
#define GLIBRA_CLASSIC_GL(X) \
    X(AttachShader) X(BindAttribLocation) X(CompileShader) X(CreateProgram) X(CreateShader) X(DeleteProgram) \
    X(DeleteShader) X(GetProgramInfoLog) X(GetProgramiv) X(GetShaderInfoLog) X(GetShaderiv) X(LinkProgram) \
    X(ShaderSource) X(UseProgram) \
    X(GetActiveAttrib) X(GetActiveUniform) X(GetAttribLocation) X(GetUniformLocation) \
    X(ProgramUniform1fv) X(ProgramUniform2fv) X(ProgramUniform3fv) X(ProgramUniform4fv) \
    X(ProgramUniform1iv) X(ProgramUniform2iv) X(ProgramUniform3iv) X(ProgramUniform4iv) \
    X(ProgramUniform1uiv) X(ProgramUniform2uiv) X(ProgramUniform3uiv) X(ProgramUniform4uiv) \
    X(ProgramUniformMatrix2fv) X(ProgramUniformMatrix3fv) X(ProgramUniformMatrix4fv) \
    X(BindBuffer) X(BufferData) X(BufferSubData) X(DeleteBuffers) X(GenBuffers) \
    X(BindVertexArray) X(DeleteVertexArrays) X(GenVertexArrays) X(VertexAttribPointer) \
    X(DisableVertexAttribArray) X(EnableVertexAttribArray) X(VertexAttrib4fv) X(VertexAttribI4iv) \
    X(DrawElementsIndirect) X(DrawElementsInstanced) X(MultiDrawElements) \
    X(PatchParameteri) X(PrimitiveRestartIndex) X(Disable) X(Enable) X(GetIntegerv) X(GetStringi) X(IsEnabled)
// clang-format on

// NOLINTBEGIN(readability-identifier-naming, bugprone-macro-parentheses): GL's own names
struct Gl {
#define GLIBRA_CLASSIC_MEMBER(name) decltype(glad_gl##name) name = nullptr;
    GLIBRA_CLASSIC_GL(GLIBRA_CLASSIC_MEMBER)
#undef GLIBRA_CLASSIC_MEMBER
    PFNGLMULTIDRAWELEMENTSINDIRECTPROC MultiDrawElementsIndirect = nullptr;  ///< null before OpenGL 4.3
    int version = 0;                                                         ///< 45 is OpenGL 4.5
    std::set<std::string, std::less<>> extensions;
    void* (*currentHandle)() = nullptr;

    [[nodiscard]] GLint number(GLenum name) const;
};
// NOLINTEND(readability-identifier-naming, bugprone-macro-parentheses)

/// The functions of the context that is current on this thread. Null if there is none of OpenGL 4.1 or later,
/// or the process was forked after its parent had used a driver; `who` is then told so on standard error. The
/// functions stay until the process ends.
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
    /// False in a forked process, where nothing of the context can be used.
    [[nodiscard]] bool isCurrent() const {
        return gl_ != nullptr && !gpu::isForked() && gl_->currentHandle() == context_;
    }
    [[nodiscard]] void* context() const { return context_; }

  private:
    const Gl* gl_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace glibra::classic
