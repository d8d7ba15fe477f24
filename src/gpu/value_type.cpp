#include "gpu/value_type.h"

#include <algorithm>
#include <array>

namespace glibra::gpu {
namespace {

using enum BaseType;

constexpr ValueType numeric(GLenum type, std::string_view word, BaseType base, int columns, int rows) {
    return {type, word, base, columns, rows, 0};
}
constexpr ValueType opaque(GLenum type, std::string_view word, BaseType base, GLenum target) {
    return {type, word, base, 1, 1, target};
}

constexpr auto kTypes = std::to_array<ValueType>({
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

    opaque(GL_SAMPLER_1D, "sampler1D", sampler, GL_TEXTURE_1D),
    opaque(GL_SAMPLER_2D, "sampler2D", sampler, GL_TEXTURE_2D),
    opaque(GL_SAMPLER_3D, "sampler3D", sampler, GL_TEXTURE_3D),
    opaque(GL_SAMPLER_CUBE, "samplerCube", sampler, GL_TEXTURE_CUBE_MAP),
    opaque(GL_SAMPLER_1D_SHADOW, "sampler1DShadow", sampler, GL_TEXTURE_1D),
    opaque(GL_SAMPLER_2D_SHADOW, "sampler2DShadow", sampler, GL_TEXTURE_2D),
    opaque(GL_SAMPLER_CUBE_SHADOW, "samplerCubeShadow", sampler, GL_TEXTURE_CUBE_MAP),
    opaque(GL_SAMPLER_1D_ARRAY, "sampler1DArray", sampler, GL_TEXTURE_1D_ARRAY),
    opaque(GL_SAMPLER_2D_ARRAY, "sampler2DArray", sampler, GL_TEXTURE_2D_ARRAY),
    opaque(GL_SAMPLER_CUBE_MAP_ARRAY, "samplerCubeArray", sampler, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_SAMPLER_1D_ARRAY_SHADOW, "sampler1DArrayShadow", sampler, GL_TEXTURE_1D_ARRAY),
    opaque(GL_SAMPLER_2D_ARRAY_SHADOW, "sampler2DArrayShadow", sampler, GL_TEXTURE_2D_ARRAY),
    opaque(GL_SAMPLER_CUBE_MAP_ARRAY_SHADOW, "samplerCubeArrayShadow", sampler, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_SAMPLER_2D_RECT, "sampler2DRect", sampler, GL_TEXTURE_RECTANGLE),
    opaque(GL_SAMPLER_2D_RECT_SHADOW, "sampler2DRectShadow", sampler, GL_TEXTURE_RECTANGLE),
    opaque(GL_SAMPLER_BUFFER, "samplerBuffer", sampler, GL_TEXTURE_BUFFER),
    opaque(GL_SAMPLER_2D_MULTISAMPLE, "sampler2DMS", sampler, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_SAMPLER_2D_MULTISAMPLE_ARRAY, "sampler2DMSArray", sampler, GL_TEXTURE_2D_MULTISAMPLE_ARRAY),
    opaque(GL_INT_SAMPLER_1D, "isampler1D", sampler, GL_TEXTURE_1D),
    opaque(GL_INT_SAMPLER_2D, "isampler2D", sampler, GL_TEXTURE_2D),
    opaque(GL_INT_SAMPLER_3D, "isampler3D", sampler, GL_TEXTURE_3D),
    opaque(GL_INT_SAMPLER_CUBE, "isamplerCube", sampler, GL_TEXTURE_CUBE_MAP),
    opaque(GL_INT_SAMPLER_1D_ARRAY, "isampler1DArray", sampler, GL_TEXTURE_1D_ARRAY),
    opaque(GL_INT_SAMPLER_2D_ARRAY, "isampler2DArray", sampler, GL_TEXTURE_2D_ARRAY),
    opaque(GL_INT_SAMPLER_CUBE_MAP_ARRAY, "isamplerCubeArray", sampler, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_INT_SAMPLER_2D_RECT, "isampler2DRect", sampler, GL_TEXTURE_RECTANGLE),
    opaque(GL_INT_SAMPLER_BUFFER, "isamplerBuffer", sampler, GL_TEXTURE_BUFFER),
    opaque(GL_INT_SAMPLER_2D_MULTISAMPLE, "isampler2DMS", sampler, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "isampler2DMSArray", sampler,
           GL_TEXTURE_2D_MULTISAMPLE_ARRAY),
    opaque(GL_UNSIGNED_INT_SAMPLER_1D, "usampler1D", sampler, GL_TEXTURE_1D),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D, "usampler2D", sampler, GL_TEXTURE_2D),
    opaque(GL_UNSIGNED_INT_SAMPLER_3D, "usampler3D", sampler, GL_TEXTURE_3D),
    opaque(GL_UNSIGNED_INT_SAMPLER_CUBE, "usamplerCube", sampler, GL_TEXTURE_CUBE_MAP),
    opaque(GL_UNSIGNED_INT_SAMPLER_1D_ARRAY, "usampler1DArray", sampler, GL_TEXTURE_1D_ARRAY),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, "usampler2DArray", sampler, GL_TEXTURE_2D_ARRAY),
    opaque(GL_UNSIGNED_INT_SAMPLER_CUBE_MAP_ARRAY, "usamplerCubeArray", sampler, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_RECT, "usampler2DRect", sampler, GL_TEXTURE_RECTANGLE),
    opaque(GL_UNSIGNED_INT_SAMPLER_BUFFER, "usamplerBuffer", sampler, GL_TEXTURE_BUFFER),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE, "usampler2DMS", sampler, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY, "usampler2DMSArray", sampler,
           GL_TEXTURE_2D_MULTISAMPLE_ARRAY),

    opaque(GL_IMAGE_1D, "image1D", image, GL_TEXTURE_1D),
    opaque(GL_IMAGE_2D, "image2D", image, GL_TEXTURE_2D),
    opaque(GL_IMAGE_3D, "image3D", image, GL_TEXTURE_3D),
    opaque(GL_IMAGE_2D_RECT, "image2DRect", image, GL_TEXTURE_RECTANGLE),
    opaque(GL_IMAGE_CUBE, "imageCube", image, GL_TEXTURE_CUBE_MAP),
    opaque(GL_IMAGE_BUFFER, "imageBuffer", image, GL_TEXTURE_BUFFER),
    opaque(GL_IMAGE_1D_ARRAY, "image1DArray", image, GL_TEXTURE_1D_ARRAY),
    opaque(GL_IMAGE_2D_ARRAY, "image2DArray", image, GL_TEXTURE_2D_ARRAY),
    opaque(GL_IMAGE_CUBE_MAP_ARRAY, "imageCubeArray", image, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_IMAGE_2D_MULTISAMPLE, "image2DMS", image, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_IMAGE_2D_MULTISAMPLE_ARRAY, "image2DMSArray", image, GL_TEXTURE_2D_MULTISAMPLE_ARRAY),
    opaque(GL_INT_IMAGE_1D, "iimage1D", image, GL_TEXTURE_1D),
    opaque(GL_INT_IMAGE_2D, "iimage2D", image, GL_TEXTURE_2D),
    opaque(GL_INT_IMAGE_3D, "iimage3D", image, GL_TEXTURE_3D),
    opaque(GL_INT_IMAGE_2D_RECT, "iimage2DRect", image, GL_TEXTURE_RECTANGLE),
    opaque(GL_INT_IMAGE_CUBE, "iimageCube", image, GL_TEXTURE_CUBE_MAP),
    opaque(GL_INT_IMAGE_BUFFER, "iimageBuffer", image, GL_TEXTURE_BUFFER),
    opaque(GL_INT_IMAGE_1D_ARRAY, "iimage1DArray", image, GL_TEXTURE_1D_ARRAY),
    opaque(GL_INT_IMAGE_2D_ARRAY, "iimage2DArray", image, GL_TEXTURE_2D_ARRAY),
    opaque(GL_INT_IMAGE_CUBE_MAP_ARRAY, "iimageCubeArray", image, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_INT_IMAGE_2D_MULTISAMPLE, "iimage2DMS", image, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_INT_IMAGE_2D_MULTISAMPLE_ARRAY, "iimage2DMSArray", image, GL_TEXTURE_2D_MULTISAMPLE_ARRAY),
    opaque(GL_UNSIGNED_INT_IMAGE_1D, "uimage1D", image, GL_TEXTURE_1D),
    opaque(GL_UNSIGNED_INT_IMAGE_2D, "uimage2D", image, GL_TEXTURE_2D),
    opaque(GL_UNSIGNED_INT_IMAGE_3D, "uimage3D", image, GL_TEXTURE_3D),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_RECT, "uimage2DRect", image, GL_TEXTURE_RECTANGLE),
    opaque(GL_UNSIGNED_INT_IMAGE_CUBE, "uimageCube", image, GL_TEXTURE_CUBE_MAP),
    opaque(GL_UNSIGNED_INT_IMAGE_BUFFER, "uimageBuffer", image, GL_TEXTURE_BUFFER),
    opaque(GL_UNSIGNED_INT_IMAGE_1D_ARRAY, "uimage1DArray", image, GL_TEXTURE_1D_ARRAY),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_ARRAY, "uimage2DArray", image, GL_TEXTURE_2D_ARRAY),
    opaque(GL_UNSIGNED_INT_IMAGE_CUBE_MAP_ARRAY, "uimageCubeArray", image, GL_TEXTURE_CUBE_MAP_ARRAY),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE, "uimage2DMS", image, GL_TEXTURE_2D_MULTISAMPLE),
    opaque(GL_UNSIGNED_INT_IMAGE_2D_MULTISAMPLE_ARRAY, "uimage2DMSArray", image,
           GL_TEXTURE_2D_MULTISAMPLE_ARRAY),

    opaque(GL_UNSIGNED_INT_ATOMIC_COUNTER, "atomic_uint", atomicCounter, 0),
});

}  // namespace

ValueType valueType(GLenum type) {
    const auto* const found = std::find_if(kTypes.begin(), kTypes.end(),
                                           [type](const ValueType& each) { return each.type == type; });
    if (found != kTypes.end()) return *found;
    ValueType unknown;
    unknown.type = type;
    return unknown;
}

}  // namespace glibra::gpu
