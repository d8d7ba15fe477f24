#include "gpu/format/gl_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::gpu {
namespace {

using enum base::BaseType;
using enum base::TextureTarget;

using AnyTarget = std::optional<base::TextureTarget>;
constexpr AnyTarget kNone = std::nullopt;  // no unit of a scene holds such textures

struct Row {
    GLenum type;
    std::string_view word;
    base::BaseType base;
    int columns, rows;
    AnyTarget target;
};

constexpr Row numeric(GLenum type, std::string_view word, base::BaseType base, int columns, int rows) {
    return {type, word, base, columns, rows, kNone};
}
constexpr Row opaque(GLenum type, std::string_view word, base::BaseType base, AnyTarget target) {
    return {type, word, base, 1, 1, target};
}

constexpr auto kTypes = std::to_array<Row>({
    numeric(GL_FLOAT, "float", floating, 1, 1),
    numeric(GL_FLOAT_VEC2, "vec2", floating, 1, 2),
    numeric(GL_FLOAT_VEC3, "vec3", floating, 1, 3),
    numeric(GL_FLOAT_VEC4, "vec4", floating, 1, 4),
    numeric(GL_DOUBLE, "double", doublePrecision, 1, 1),
    numeric(GL_DOUBLE_VEC2, "dvec2", doublePrecision, 1, 2),
    numeric(GL_DOUBLE_VEC3, "dvec3", doublePrecision, 1, 3),
    numeric(GL_DOUBLE_VEC4, "dvec4", doublePrecision, 1, 4),
    numeric(GL_INT, "int", integer, 1, 1),
    numeric(GL_INT_VEC2, "ivec2", integer, 1, 2),
    numeric(GL_INT_VEC3, "ivec3", integer, 1, 3),
    numeric(GL_INT_VEC4, "ivec4", integer, 1, 4),
    numeric(GL_UNSIGNED_INT, "uint", unsignedInteger, 1, 1),
    numeric(GL_UNSIGNED_INT_VEC2, "uvec2", unsignedInteger, 1, 2),
    numeric(GL_UNSIGNED_INT_VEC3, "uvec3", unsignedInteger, 1, 3),
    numeric(GL_UNSIGNED_INT_VEC4, "uvec4", unsignedInteger, 1, 4),
    numeric(GL_BOOL, "bool", boolean, 1, 1),
    numeric(GL_BOOL_VEC2, "bvec2", boolean, 1, 2),
    numeric(GL_BOOL_VEC3, "bvec3", boolean, 1, 3),
    numeric(GL_BOOL_VEC4, "bvec4", boolean, 1, 4),
    numeric(GL_FLOAT_MAT2, "mat2", floating, 2, 2),
    numeric(GL_FLOAT_MAT3, "mat3", floating, 3, 3),
    numeric(GL_FLOAT_MAT4, "mat4", floating, 4, 4),
    numeric(GL_FLOAT_MAT2x3, "mat2x3", floating, 2, 3),
    numeric(GL_FLOAT_MAT2x4, "mat2x4", floating, 2, 4),
    numeric(GL_FLOAT_MAT3x2, "mat3x2", floating, 3, 2),
    numeric(GL_FLOAT_MAT3x4, "mat3x4", floating, 3, 4),
    numeric(GL_FLOAT_MAT4x2, "mat4x2", floating, 4, 2),
    numeric(GL_FLOAT_MAT4x3, "mat4x3", floating, 4, 3),
    numeric(GL_DOUBLE_MAT2, "dmat2", doublePrecision, 2, 2),
    numeric(GL_DOUBLE_MAT3, "dmat3", doublePrecision, 3, 3),
    numeric(GL_DOUBLE_MAT4, "dmat4", doublePrecision, 4, 4),
    numeric(GL_DOUBLE_MAT2x3, "dmat2x3", doublePrecision, 2, 3),
    numeric(GL_DOUBLE_MAT2x4, "dmat2x4", doublePrecision, 2, 4),
    numeric(GL_DOUBLE_MAT3x2, "dmat3x2", doublePrecision, 3, 2),
    numeric(GL_DOUBLE_MAT3x4, "dmat3x4", doublePrecision, 3, 4),
    numeric(GL_DOUBLE_MAT4x2, "dmat4x2", doublePrecision, 4, 2),
    numeric(GL_DOUBLE_MAT4x3, "dmat4x3", doublePrecision, 4, 3),

    opaque(GL_SAMPLER_1D, "sampler1D", sampler, texture1D),
    opaque(GL_SAMPLER_2D, "sampler2D", sampler, texture2D),
    opaque(GL_SAMPLER_3D, "sampler3D", sampler, texture3D),
    opaque(GL_SAMPLER_CUBE, "samplerCube", sampler, cube),
    opaque(GL_SAMPLER_1D_SHADOW, "sampler1DShadow", sampler, texture1D),
    opaque(GL_SAMPLER_2D_SHADOW, "sampler2DShadow", sampler, texture2D),
    opaque(GL_SAMPLER_CUBE_SHADOW, "samplerCubeShadow", sampler, cube),
    opaque(GL_SAMPLER_1D_ARRAY, "sampler1DArray", sampler, kNone),
    opaque(GL_SAMPLER_2D_ARRAY, "sampler2DArray", sampler, kNone),
    opaque(GL_SAMPLER_CUBE_MAP_ARRAY, "samplerCubeArray", sampler, kNone),
    opaque(GL_SAMPLER_1D_ARRAY_SHADOW, "sampler1DArrayShadow", sampler, kNone),
    opaque(GL_SAMPLER_2D_ARRAY_SHADOW, "sampler2DArrayShadow", sampler, kNone),
    opaque(GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW, "samplerCubeArrayShadow", sampler, kNone),
    opaque(GL_SAMPLER_2D_RECT, "sampler2DRect", sampler, kNone),
    opaque(GL_SAMPLER_2D_RECT_SHADOW, "sampler2DRectShadow", sampler, kNone),
    opaque(GL_SAMPLER_BUFFER, "samplerBuffer", sampler, kNone),
    opaque(GL_SAMPLER_2D_MULTISAMPLE, "sampler2DMS", sampler, kNone),
    opaque(GL_SAMPLER_2D_MULTISAMPLE_ARRAY, "sampler2DMSArray", sampler, kNone),
    opaque(GL_INT_SAMPLER_1D, "isampler1D", sampler, texture1D),
    opaque(GL_INT_SAMPLER_2D, "isampler2D", sampler, texture2D),
    opaque(GL_INT_SAMPLER_3D, "isampler3D", sampler, texture3D),
    opaque(GL_INT_SAMPLER_CUBE, "isamplerCube", sampler, cube),
    opaque(GL_INT_SAMPLER_1D_ARRAY, "isampler1DArray", sampler, kNone),
    opaque(GL_INT_SAMPLER_2D_ARRAY, "isampler2DArray", sampler, kNone),
    opaque(GL_INT_SAMPLER_CUBE_MAP_ARRAY, "isamplerCubeArray", sampler, kNone),
    opaque(GL_INT_SAMPLER_2D_RECT, "isampler2DRect", sampler, kNone),
    opaque(GL_INT_SAMPLER_BUFFER, "isamplerBuffer", sampler, kNone),
    opaque(GL_INT_SAMPLER_2D_MULTISAMPLE, "isampler2DMS", sampler, kNone),
    opaque(GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "isampler2DMSArray", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_1D, "usampler1D", sampler, texture1D),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D, "usampler2D", sampler, texture2D),
    opaque(GL_UNSIGNED_INT_SAMPLER_3D, "usampler3D", sampler, texture3D),
    opaque(GL_UNSIGNED_INT_SAMPLER_CUBE, "usamplerCube", sampler, cube),
    opaque(GL_UNSIGNED_INT_SAMPLER_1D_ARRAY, "usampler1DArray", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, "usampler2DArray", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY, "usamplerCubeArray", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_RECT, "usampler2DRect", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_BUFFER, "usamplerBuffer", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE, "usampler2DMS", sampler, kNone),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "usampler2DMSArray", sampler, kNone),

    opaque(GL_IMAGE_1D, "image1D", image, texture1D),
    opaque(GL_IMAGE_2D, "image2D", image, texture2D),
    opaque(GL_IMAGE_3D, "image3D", image, texture3D),
    opaque(GL_IMAGE_2D_RECT, "image2DRect", image, kNone),
    opaque(GL_IMAGE_CUBE, "imageCube", image, cube),
    opaque(GL_IMAGE_BUFFER, "imageBuffer", image, kNone),
    opaque(GL_IMAGE_1D_ARRAY, "image1DArray", image, kNone),
    opaque(GL_IMAGE_2D_ARRAY, "image2DArray", image, kNone),
    opaque(GL_IMAGE_CUBE_MAP_ARRAY, "imageCubeArray", image, kNone),
    opaque(GL_IMAGE_2D_MULTISAMPLE, "image2DMS", image, kNone),
    opaque(GL_IMAGE_2D_MULTISAMPLE_ARRAY, "image2DMSArray", image, kNone),
    opaque(GL_INT_IMAGE_1D, "iimage1D", image, texture1D),
    opaque(GL_INT_IMAGE_2D, "iimage2D", image, texture2D),
    opaque(GL_INT_IMAGE_3D, "iimage3D", image, texture3D),
    opaque(GL_INT_IMAGE_2D_RECT, "iimage2DRect", image, kNone),
    opaque(GL_INT_IMAGE_CUBE, "iimageCube", image, cube),
    opaque(GL_INT_IMAGE_BUFFER, "iimageBuffer", image, kNone),
    opaque(GL_INT_IMAGE_1D_ARRAY, "iimage1DArray", image, kNone),
    opaque(GL_INT_IMAGE_2D_ARRAY, "iimage2DArray", image, kNone),
    opaque(GL_INT_IMAGE_CUBE_MAP_ARRAY, "iimageCubeArray", image, kNone),
    opaque(GL_INT_IMAGE_2D_MULTISAMPLE, "iimage2DMS", image, kNone),
    opaque(GL_INT_IMAGE_2D_MULTISAMPLE_ARRAY, "iimage2DMSArray", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_1D, "uimage1D", image, texture1D),
    opaque(GL_UNSIGNED_INT_IMAGE_2D, "uimage2D", image, texture2D),
    opaque(GL_UNSIGNED_INT_IMAGE_3D, "uimage3D", image, texture3D),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_RECT, "uimage2DRect", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_CUBE, "uimageCube", image, cube),
    opaque(GL_UNSIGNED_INT_IMAGE_BUFFER, "uimageBuffer", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_1D_ARRAY, "uimage1DArray", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_ARRAY, "uimage2DArray", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_CUBE_MAP_ARRAY, "uimageCubeArray", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE, "uimage2DMS", image, kNone),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY, "uimage2DMSArray", image, kNone),

    opaque(GL_UNSIGNED_INT_ATOMIC_COUNTER, "atomic_uint", other, kNone),
});

}  // namespace

base::ValueType valueType(GLenum type) {
    const auto* const found =
        std::ranges::find_if(kTypes, [type](const Row& each) { return each.type == type; });
    if (found == kTypes.end()) return {.base = other};
    return {found->base, found->columns, found->rows, found->target, std::string(found->word)};
}

GLenum glFunction(base::Comparison comparison) {
    constexpr std::array<GLenum, 8> kFunctions{GL_NEVER,  GL_LESS,    GL_LEQUAL,   GL_EQUAL,
                                               GL_GEQUAL, GL_GREATER, GL_NOTEQUAL, GL_ALWAYS};
    return kFunctions.at(static_cast<std::size_t>(comparison));
}

GLenum glFactor(base::BlendFactor factor) {
    constexpr std::array<GLenum, base::kBlendFactorCount> kFactors{GL_ZERO,
                                                                   GL_ONE,
                                                                   GL_SRC_COLOR,
                                                                   GL_ONE_MINUS_SRC_COLOR,
                                                                   GL_DST_COLOR,
                                                                   GL_ONE_MINUS_DST_COLOR,
                                                                   GL_SRC_ALPHA,
                                                                   GL_ONE_MINUS_SRC_ALPHA,
                                                                   GL_DST_ALPHA,
                                                                   GL_ONE_MINUS_DST_ALPHA,
                                                                   GL_CONSTANT_COLOR,
                                                                   GL_ONE_MINUS_CONSTANT_COLOR,
                                                                   GL_CONSTANT_ALPHA,
                                                                   GL_ONE_MINUS_CONSTANT_ALPHA,
                                                                   GL_SRC_ALPHA_SATURATE};
    return kFactors.at(static_cast<std::size_t>(factor));
}

GLenum glEquation(base::BlendEquation equation) {
    constexpr std::array<GLenum, base::kBlendEquationCount> kEquations{
        GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    return kEquations.at(static_cast<std::size_t>(equation));
}

GLenum glAction(base::StencilAction action) {
    constexpr std::array<GLenum, 8> kActions{GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                             GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    return kActions.at(static_cast<std::size_t>(action));
}

}  // namespace glibra::gpu
