#pragma once
// GLSLProgram, a class of the appendix of "Graphics Shaders". docs/classic.md has what the book leaves open.

#include <glibra/classic/matrix4.h>
#include <glibra/classic/vec3.h>
#include <glibra/diagnostic.h>
#include <glibra/export.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace glibra::classic {

/// A program of shaders in the context that is current on this thread (OpenGL 4.1 or later, core or not).
/// Shaders may be of any dialect that glibra's scenes take. Errors are written to standard error with the
/// user's file and line. It makes nothing before Create(), and has to end while its context is current.
class GLIBRA_API GLSLProgram {
  public:
    GLSLProgram();
    ~GLSLProgram();
    GLSLProgram(GLSLProgram&&) noexcept;
    GLSLProgram& operator=(GLSLProgram&&) noexcept;

    /// Builds a program of up to five files: the extension .vert, .tcs, .tes, .geom or .frag says which
    /// stage.
    bool Create(const char* file1, const char* file2 = nullptr, const char* file3 = nullptr,
                const char* file4 = nullptr, const char* file5 = nullptr);
    /// The same of pairs of a name with such an extension and a text. The names stand in messages.
    bool CreateFromText(const std::vector<std::pair<std::string, std::string>>& texts);
    [[nodiscard]] bool IsValid() const;

    // Before Create():
    /// Also writes warnings, and the uniforms and attributes with their locations.
    void SetVerbose(bool isOn);
    /// True, the default: shaders may use the names of gstap.h without declaring them, and old dialects.
    /// False: they are compiled as core GLSL.
    void SetGstap(bool isOn);
    void SetGstab(bool isOn) { SetGstap(isOn); }  ///< as the book's list of methods spells it
    /// What a geometry shader without layout qualifiers takes and makes: GL_TRIANGLES, GL_LINE_STRIP, ...
    void SetInputTopology(unsigned int topology);
    void SetOutputTopology(unsigned int topology);

    // After Create(), whether or not the program is in use. A pointer is to as many floats as the variable
    // has components. A name that the program does not have is reported once.
    void SetAttribute(const char* name, int value);
    void SetAttribute(const char* name, float value);
    void SetAttribute(const char* name, double value) { SetAttribute(name, static_cast<float>(value)); }
    void SetAttribute(const char* name, float x, float y, float z);
    void SetAttribute(const char* name, const float* values);
    void SetAttribute(const char* name, const Vec3& value);
    void SetUniform(const char* name, int value);
    void SetUniform(const char* name, float value);
    void SetUniform(const char* name, double value) { SetUniform(name, static_cast<float>(value)); }
    void SetUniform(const char* name, float x, float y, float z);
    void SetUniform(const char* name, const float* values);
    void SetUniform(const char* name, const Vec3& value);
    void SetUniform(const char* name, const Matrix4& value);

    /// Without a valid program nothing is drawn.
    void Use();
    /// No program is in use. A core profile draws nothing then.
    void UseFixedFunction();

    /// GL's name of the program; 0 without one.
    [[nodiscard]] unsigned int Id() const;
    /// The errors, warnings and notes of the last Create().
    [[nodiscard]] const Diagnostics& Messages() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace glibra::classic
