#include "gpu/object/vertex_array.h"

#include "base/number.h"

namespace glibra::gpu {
namespace {

const void* byteOffset(std::size_t offset) {
    // GL takes the offset as a pointer.
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

void connect(const AttributeSource& source) {
    using Type = AttributeSource::Type;
    source.buffer->bind(GL_ARRAY_BUFFER);
    const auto stride = static_cast<GLsizei>(source.stride);
    const bool isUnsigned = source.type == Type::unsignedInteger || source.type == Type::unsignedAsFloat;
    const GLenum memory = source.type == Type::floating ? GL_FLOAT : isUnsigned ? GL_UNSIGNED_INT : GL_INT;
    if (source.type == Type::integer || source.type == Type::unsignedInteger)
        glVertexAttribIPointer(source.location, source.components, memory, stride, byteOffset(source.offset));
    else
        glVertexAttribPointer(source.location, source.components, memory, GL_FALSE, stride,
                              byteOffset(source.offset));
    glEnableVertexAttribArray(source.location);
    if (source.divisor != 0) glVertexAttribDivisor(source.location, source.divisor);
}

}  // namespace

VertexArray::VertexArray(std::span<const AttributeSource> sources, const Buffer* indices) {
    bind();
    for (const AttributeSource& each : sources)
        if (each.buffer) connect(each);
    if (indices) indices->bind(GL_ELEMENT_ARRAY_BUFFER);
    glBindVertexArray(0);
}

void setConstantAttribute(GLuint location, const base::ValueType& type, const std::array<double, 4>& value) {
    for (GLuint column = 0; column < static_cast<GLuint>(type.columns); ++column) {
        const GLuint at = location + column;
        switch (type.base) {
            case base::BaseType::integer:
                glVertexAttribI4i(at, base::toInt(value[0]), base::toInt(value[1]), base::toInt(value[2]),
                                  base::toInt(value[3]));
                break;
            case base::BaseType::unsignedInteger:
                glVertexAttribI4ui(at, base::toUnsigned(value[0]), base::toUnsigned(value[1]),
                                   base::toUnsigned(value[2]), base::toUnsigned(value[3]));
                break;
            case base::BaseType::doublePrecision:
                glVertexAttribL4dv(at, value.data());
                break;
            default:
                glVertexAttrib4f(at, static_cast<float>(value[0]), static_cast<float>(value[1]),
                                 static_cast<float>(value[2]), static_cast<float>(value[3]));
                break;
        }
    }
}

}  // namespace glibra::gpu
