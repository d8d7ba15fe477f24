#include "glsl/types/builtins.h"

#include <algorithm>
#include <array>
#include <string>

namespace glibra::glsl {
namespace {

using enum Builtin;

constexpr std::array kUniforms = std::to_array<BuiltinUniform>({
    {"Timer", "float", timer},
    {"Noise2", "sampler2D", noise2},
    {"Noise3", "sampler3D", noise3},
    {"uModelViewMatrix", "mat4", modelView},
    {"uProjectionMatrix", "mat4", projection},
    {"uModelViewProjectionMatrix", "mat4", modelViewProjection},
    {"uNormalMatrix", "mat3", normalMatrix},
    {"uModelViewMatrixInverse", "mat4", modelViewInverse},
    {"uModelViewMatrixTranspose", "mat4", modelViewTranspose},
    {"uModelViewMatrixInverseTranspose", "mat4", modelViewInverseTranspose},
    {"glibra_ModelViewMatrix", "mat4", modelView},
    {"glibra_ProjectionMatrix", "mat4", projection},
    {"glibra_ModelViewProjectionMatrix", "mat4", modelViewProjection},
    {"glibra_NormalMatrix", "mat3", normalMatrix},
    {"glibra_ModelViewMatrixInverse", "mat4", modelViewInverse},
    {"glibra_ModelViewMatrixTranspose", "mat4", modelViewTranspose},
    {"glibra_ModelViewMatrixInverseTranspose", "mat4", modelViewInverseTranspose},
    {"glibra_ProjectionMatrixInverse", "mat4", projectionInverse},
    {"glibra_ProjectionMatrixTranspose", "mat4", projectionTranspose},
    {"glibra_ProjectionMatrixInverseTranspose", "mat4", projectionInverseTranspose},
    {"glibra_ModelViewProjectionMatrixInverse", "mat4", modelViewProjectionInverse},
    {"glibra_ModelViewProjectionMatrixTranspose", "mat4", modelViewProjectionTranspose},
    {"glibra_ModelViewProjectionMatrixInverseTranspose", "mat4", modelViewProjectionInverseTranspose},
    {"glibra_TextureMatrix", "mat4", textureMatrix},
    {"glibra_TextureMatrixInverse", "mat4", textureMatrixInverse},
    {"glibra_TextureMatrixTranspose", "mat4", textureMatrixTranspose},
    {"glibra_TextureMatrixInverseTranspose", "mat4", textureMatrixInverseTranspose},
    {"glibra_CurrentColor", "vec4", currentColor},
    {"glibra_PointSize", "float", pointSize},
});

constexpr std::array kInputs = std::to_array<BuiltinInput>({
    {"aVertex", "position"},
    {"glibra_Vertex", "position"},
    {"aNormal", "normal"},
    {"glibra_Normal", "normal"},
    {"aColor", "color"},
    {"glibra_Color", "color"},
    {"aTexCoord0", "texCoord"},
    {"glibra_MultiTexCoord0", "texCoord"},
    {"aTexCoord1", ""},
    {"glibra_MultiTexCoord1", ""},
    {"aTexCoord2", ""},
    {"glibra_MultiTexCoord2", ""},
    {"aTexCoord3", ""},
    {"glibra_MultiTexCoord3", ""},
    {"aTexCoord4", ""},
    {"glibra_MultiTexCoord4", ""},
    {"aTexCoord5", ""},
    {"glibra_MultiTexCoord5", ""},
    {"aTexCoord6", ""},
    {"glibra_MultiTexCoord6", ""},
    {"aTexCoord7", ""},
    {"glibra_MultiTexCoord7", ""},
    {"Tangent", "tangent"},
    {"aTangent", "tangent"},
    {"FaceIndex", "faceIndex"},
    {"aFaceIndex", "faceIndex"},
    {"glibra_SecondaryColor", ""},
    {"glibra_FogCoord", ""},
});

}  // namespace

std::string emittedName(std::string_view name) {
    return name.starts_with("gl_") ? "glibra_" + std::string(name.substr(3)) : std::string(name);
}

std::span<const BuiltinUniform> builtinUniforms() {
    return kUniforms;
}

std::span<const BuiltinInput> builtinInputs() {
    return kInputs;
}

const BuiltinUniform* findBuiltinUniform(std::string_view name) {
    const std::string key = emittedName(name);
    const auto* const found =
        std::ranges::find_if(kUniforms, [&](const auto& row) { return row.name == key; });
    return found == kUniforms.end() ? nullptr : found;
}

const BuiltinInput* findBuiltinInput(std::string_view name) {
    const std::string key = emittedName(name);
    const auto* const found = std::ranges::find_if(kInputs, [&](const auto& row) { return row.name == key; });
    return found == kInputs.end() ? nullptr : found;
}

}  // namespace glibra::glsl
