#pragma once
// The values that the runtime supplies to shaders by name (language, section 6): one table row a name.

#include <span>
#include <string_view>

namespace glibra::glsl {

/// What a built-in uniform holds. Matrix values are filled a draw, the others when they change.
enum class Builtin {
    timer,
    noise2,
    noise3,
    modelView,
    projection,
    modelViewProjection,
    normalMatrix,
    modelViewInverse,
    modelViewTranspose,
    modelViewInverseTranspose,
    projectionInverse,
    projectionTranspose,
    projectionInverseTranspose,
    modelViewProjectionInverse,
    modelViewProjectionTranspose,
    modelViewProjectionInverseTranspose,
    textureMatrix,
    textureMatrixInverse,
    textureMatrixTranspose,
    textureMatrixInverseTranspose,
    currentColor,  ///< gl_Color in a fragment stage that no earlier stage feeds
    pointSize,     ///< gl_Point.size
};

/// A uniform name as it appears in a linked program, its GLSL type and what fills it.
struct BuiltinUniform {
    std::string_view name;  ///< "uModelViewMatrix", "glibra_ProjectionMatrixInverse", "Timer", ...
    std::string_view type;  ///< GLSL type word: a user's declaration with another type is an ordinary uniform
    Builtin value;
};

/// A vertex input name as it appears in a linked program and the mesh attribute that feeds it.
struct BuiltinInput {
    std::string_view name;       ///< "aVertex", "glibra_Vertex", "aTexCoord0", "Tangent", "aFaceIndex", ...
    std::string_view attribute;  ///< geometry's attribute name ("position", ...); empty: constant (0, 0, 0, 1)
};

std::span<const BuiltinUniform> builtinUniforms();
std::span<const BuiltinInput> builtinInputs();

}  // namespace glibra::glsl
