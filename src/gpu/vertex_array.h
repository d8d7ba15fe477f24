#pragma once
// Which buffer feeds which vertex input, and constant values for inputs that no buffer feeds.

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <span>

#include "gpu/buffer.h"

namespace glibra::gpu {

inline void deleteVertexArray(GLuint name) {
    glDeleteVertexArrays(1, &name);
}

/// One vertex input read from a buffer.
struct AttributeSource {
    enum class Type { floating, integer, unsignedInteger };  ///< 32 bits each; how the shader declares it
    const Buffer* buffer = nullptr;
    GLuint location = 0;
    int components = 4;  ///< 1..4; those missing read 0, 0, 1 (y, z, w)
    Type type = Type::floating;
    std::size_t offset = 0;  ///< bytes to the first vertex
    std::size_t stride = 0;  ///< bytes from vertex to vertex; 0: tightly packed
    GLuint divisor = 0;      ///< 0: a value each vertex; n: a value each n instances
};

class VertexArray {
  public:
    /// The buffers must live as long as this is drawn with. `indices`, if given, holds 32-bit indices.
    explicit VertexArray(std::span<const AttributeSource> sources, const Buffer* indices = nullptr);
    void bind() const { glBindVertexArray(name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<deleteVertexArray> name_;
};

/// What an input reads that no buffer feeds. This is state of the context, not of a vertex array. `glslType`
/// is the active input's GL type (GL_FLOAT_VEC4, GL_INT, GL_FLOAT_MAT4 ...): integer and double inputs take
/// their own calls, a matrix gets the value in every column.
void setConstantAttribute(GLuint location, GLenum glslType, const std::array<double, 4>& value);

}  // namespace glibra::gpu
