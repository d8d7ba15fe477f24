#pragma once
// GLSL types by their GL number.

#include <glad/gl.h>

#include <string_view>

namespace glibra::gpu {

enum class BaseType {
    floating,
    doublePrecision,
    integer,
    unsignedInteger,
    boolean,
    sampler,
    image,
    atomicCounter
};

/// What GLSL calls the type of a uniform or vertex input. Vectors have one column, scalars one row too.
struct ValueType {
    GLenum type = 0;
    std::string_view word;  ///< "vec3", "mat4x2", "isampler2DArray"
    BaseType base = BaseType::floating;
    int columns = 1;
    int rows = 1;
    GLenum textureTarget = 0;  ///< samplers and images: GL_TEXTURE_2D ..., else 0

    [[nodiscard]] int components() const { return columns * rows; }
    /// Samplers, images and counters hold one int.
    [[nodiscard]] bool isOpaque() const { return base >= BaseType::sampler; }
    /// Vertex input locations one of these takes; dvec3, dvec4 count as one here, as in GL's own limits for
    /// vertex arrays.
    [[nodiscard]] int locations() const { return columns; }
};

/// The type of that number; an unknown one has an empty word.
ValueType valueType(GLenum type);

}  // namespace glibra::gpu
