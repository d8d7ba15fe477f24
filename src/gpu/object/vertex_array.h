#pragma once
// Which buffer feeds which vertex input, and constant values for inputs that no buffer feeds.

#include <glad/gl.h>

#include <array>
#include <cstddef>
#include <span>

#include "base/program_resources.h"
#include "gpu/object/buffer.h"

namespace glibra::gpu {

/// One vertex input read from a buffer.
struct AttributeSource {
    /// 32 bits each. `...AsFloat`: integers in memory that the shader reads as floats.
    enum class Type { floating, integer, unsignedInteger, integerAsFloat, unsignedAsFloat };
    const Buffer* buffer = nullptr;
    GLuint location = 0;
    int components = 4;  ///< 1..4; missing ones read as 0, 0, 1 (y, z, w)
    Type type = Type::floating;
    std::size_t offset = 0;  ///< bytes to the first vertex
    std::size_t stride = 0;  ///< bytes from vertex to vertex; 0: tightly packed
    GLuint divisor = 0;      ///< 0: one value per vertex; n: one value per n instances
};

class VertexArray {
  public:
    /// The buffers must outlive every draw with the vertex array. `indices`, if given, holds 32-bit indices.
    explicit VertexArray(std::span<const AttributeSource> sources, const Buffer* indices = nullptr);
    void bind() const { glBindVertexArray(name_.get()); }
    [[nodiscard]] GLuint id() const { return name_.get(); }

  private:
    Name<glDeleteVertexArrays> name_{glGenVertexArrays};
};

/// Sets what an input of that type reads when no buffer feeds it. A matrix gets the value in every column.
/// This is state of the context, not of a vertex array.
void setConstantAttribute(GLuint location, const base::ValueType& type, const std::array<double, 4>& value);

}  // namespace glibra::gpu
