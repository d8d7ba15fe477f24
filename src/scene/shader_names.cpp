#include "scene/shader_names.h"

#include <algorithm>

#include "geometry/mesh.h"
#include "glsl/types/builtins.h"

namespace glibra::scene {
namespace {

using glsl::Builtin;

/// As authors write it: the translator replaces the prefix gl_ by glibra_.
std::string written(std::string_view name) {
    constexpr std::string_view kPrefix = "glibra_";
    if (!name.starts_with(kPrefix)) return std::string(name);
    return "gl_" + std::string(name.substr(kPrefix.size()));
}

/// GLSL's own name where it is not the emitted one without its prefix.
std::string writtenUniform(const glsl::BuiltinUniform& row) {
    if (row.value == Builtin::currentColor) return "gl_Color";
    if (row.value == Builtin::pointSize) return "gl_Point.size";
    return written(row.name);
}

std::string_view meaningOf(Builtin value) {
    switch (value) {
        case Builtin::timer:
            return "goes from 0 to 1 once in every period of the command Timer";
        case Builtin::noise2:
            return "the noise texture of two dimensions";
        case Builtin::noise3:
            return "the noise texture of three dimensions";
        case Builtin::modelView:
            return "from model to eye space";
        case Builtin::projection:
            return "from eye to clip space";
        case Builtin::modelViewProjection:
            return "from model to clip space";
        case Builtin::normalMatrix:
            return "normals from model to eye space";
        case Builtin::modelViewInverse:
            return "from eye to model space";
        case Builtin::modelViewTranspose:
            return "the transpose of the ModelView matrix";
        case Builtin::modelViewInverseTranspose:
            return "the inverse transpose of the ModelView matrix";
        case Builtin::projectionInverse:
            return "from clip to eye space";
        case Builtin::projectionTranspose:
            return "the transpose of the Projection matrix";
        case Builtin::projectionInverseTranspose:
            return "the inverse transpose of the Projection matrix";
        case Builtin::modelViewProjectionInverse:
            return "from clip to model space";
        case Builtin::modelViewProjectionTranspose:
            return "the transpose of the matrix from model to clip space";
        case Builtin::modelViewProjectionInverseTranspose:
            return "the inverse transpose of the matrix from model to clip space";
        case Builtin::textureMatrix:
            return "8 matrices for texture coordinates";
        case Builtin::textureMatrixInverse:
            return "their inverses";
        case Builtin::textureMatrixTranspose:
            return "their transposes";
        case Builtin::textureMatrixInverseTranspose:
            return "their inverse transposes";
        case Builtin::currentColor:
            return "the colour of the command Color, in a fragment stage";
        case Builtin::pointSize:
            return "the size of points in pixels";
        case Builtin::model:
        case Builtin::modelInverse:
        case Builtin::modelInverseTranspose:
        case Builtin::modelNormalMatrix:
        case Builtin::view:
        case Builtin::viewInverse:
        case Builtin::viewProjection:
        case Builtin::eyePosition:
            break;  // only well-known names have these
    }
    return "";
}

std::string_view typeOf(std::string_view attribute) {
    if (attribute == geometry::kNormal || attribute == geometry::kTangent) return "vec3";
    return attribute == geometry::kFaceIndex ? "int" : "vec4";
}

}  // namespace

std::vector<ShaderName> shaderNames() {
    std::vector<ShaderName> all;
    for (const glsl::BuiltinUniform& row : glsl::builtinUniforms()) {
        const std::string_view meaning = meaningOf(row.value);
        const auto same = std::ranges::find_if(
            all, [&](const ShaderName& each) { return each.meaning == meaning && each.type == row.type; });
        if (same == all.end())
            all.push_back({{writtenUniform(row)}, row.type, false, {}, std::string(meaning)});
        else
            same->names.push_back(writtenUniform(row));
    }
    for (const glsl::BuiltinInput& row : glsl::builtinInputs()) {
        const auto same = std::ranges::find_if(
            all, [&](const ShaderName& each) { return each.isInput && each.attribute == row.attribute; });
        if (same != all.end()) {
            same->names.push_back(written(row.name));
            continue;
        }
        const std::string meaning = row.attribute.empty()
                                        ? std::string("constant, (0, 0, 0, 1)")
                                        : "the " + std::string(row.attribute) + " of the vertex";
        all.push_back({{written(row.name)}, typeOf(row.attribute), true, row.attribute, meaning});
    }
    return all;
}

}  // namespace glibra::scene
