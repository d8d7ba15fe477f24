#pragma once
// What VertexArray has to know of programs that GLSLProgram made.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/program_resources.h"
#include "classic/gl_functions.h"
#include "glsl/types/builtins.h"
#include "glsl/types/translated_program.h"

namespace glibra::classic {

struct ProgramInput {
    GLuint location = 0;
    GLenum type = GL_FLOAT_VEC4;
};

struct LinkedProgram {
    std::uint64_t serial = 0;                                 ///< no two programs have the same one
    std::map<std::string, ProgramInput, std::less<>> inputs;  ///< by the user's name
    bool hasTessellation = false;
};

/// Notes a program of a context, and gives it its serial.
void remember(void* context, GLuint program, LinkedProgram facts);
void forget(void* context, GLuint program);
/// Null for a program that GLSLProgram did not make.
std::shared_ptr<const LinkedProgram> linkedProgram(void* context, GLuint program);

/// The name in a program of "aVertex", "aNormal", "aColor" and "aTexCoord0" to "aTexCoord7" as gstap.h has
/// it, of an input as a program has it ("glibra_Vertex"); other names stay.
std::string bookName(std::string_view emitted);

// The uniforms and constant attributes of one linked program: found once, set by name.

class ProgramValues {
  public:
    /// Asks the driver for all uniforms and inputs. With `isGstap`, the matrices of gstap.h are identities
    /// until they are set, and what is computed from the model-view and projection matrices follows them.
    ProgramValues(const Gl& gl, GLuint program, const glsl::TranslatedProgram& translated, bool isGstap);

    /// Values of one element of a uniform: as many as its type has, or x y z for a vec4 with w = 1.
    void set(std::string_view name, std::span<const double> values);
    /// As many floats as the uniform has, in all its elements.
    void set(std::string_view name, const float* values);
    void set(std::string_view name, const glm::dmat4& matrix);
    /// Values of an input that VertexArray or another array does not give.
    void setInput(std::string_view name, std::span<const double> values);
    void setInput(std::string_view name, const float* values);
    /// Sets the constant inputs, once the program is in use.
    void use() const;

    [[nodiscard]] const std::map<std::string, ProgramInput, std::less<>>& inputs() const { return inputs_; }
    /// One line for each uniform and each input.
    [[nodiscard]] std::string list() const;

  private:
    struct Slot {
        GLint location = -1;
        base::ValueType type;
        int size = 1;                                   ///< elements from this one on
        const glsl::BuiltinUniform* builtin = nullptr;  ///< of gstap.h
        bool isGiven = false;                           ///< the program set what would be computed
    };
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
    };

    void findUniforms(const glsl::TranslatedProgram& translated, bool isGstap);
    void findInputs(const glsl::TranslatedProgram& translated);
    /// Null, with a message the first time, for a name that the program does not have.
    Slot* slotOf(std::string_view name, std::string_view call);
    const ProgramInput* inputOf(std::string_view name);
    /// False, with a message the first time, if a number is none of the integers that the type takes.
    bool takes(const base::ValueType& type, std::string_view name, std::string_view call,
               std::span<const double> values);
    void upload(const Slot& slot, std::span<const double> values) const;
    void upload(const Slot& slot, const glm::dmat4& matrix) const;
    void deriveMatrices();
    void once(std::string_view about, const std::string& text);

    const Gl& gl_;
    GLuint program_;
    std::string who_;
    std::unordered_map<std::string, Slot, Hash, std::equal_to<>> uniforms_;  ///< by the user's name
    std::map<std::string, ProgramInput, std::less<>> inputs_;
    std::map<std::string, std::array<double, 4>, std::less<>> constants_;  ///< of inputs_
    std::map<std::string, std::string> emittedNames_;                      ///< of renamed user's names
    glm::dmat4 modelView_{1.0}, projection_{1.0};
    std::set<std::string, std::less<>> reported_;
};

}  // namespace glibra::classic
