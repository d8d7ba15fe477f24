#include "glsl/read/extensions.h"

#include <algorithm>
#include <array>

#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

// What the extensions add, from their texts in Khronos' registry.

constexpr std::string_view kConservativeDepth = "depth_any depth_greater depth_less depth_unchanged";
constexpr std::string_view kGeometryShader4 =
    "gl_PositionIn gl_PointSizeIn gl_ClipVertexIn gl_TexCoordIn gl_FrontColorIn gl_BackColorIn "
    "gl_FrontSecondaryColorIn gl_BackSecondaryColorIn gl_FogFragCoordIn gl_PrimitiveIDIn "
    "gl_VerticesIn gl_PrimitiveID gl_Layer EmitVertex EndPrimitive";
constexpr std::string_view kTessellationShader =
    "patch gl_in gl_out gl_PatchVerticesIn gl_InvocationID gl_PrimitiveID gl_TessCoord "
    "gl_TessLevelOuter gl_TessLevelInner barrier vertices triangles quads isolines equal_spacing "
    "fractional_even_spacing fractional_odd_spacing cw ccw point_mode gl_MaxPatchVertices "
    "gl_MaxTessGenLevel";
constexpr std::string_view kTextureBufferObject = "samplerBuffer isamplerBuffer usamplerBuffer";
constexpr std::string_view kTextureRectangle =
    "sampler2DRect sampler2DRectShadow texture2DRect texture2DRectProj shadow2DRect "
    "shadow2DRectProj";
constexpr std::string_view kVertexAttrib64bit =
    "double dvec2 dvec3 dvec4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3 dmat3x4 "
    "dmat4x2 dmat4x3 dmat4x4";
constexpr std::string_view kGeometryShader =
    "gl_in gl_PrimitiveIDIn gl_InvocationID gl_Layer gl_PrimitiveID EmitVertex EndPrimitive "
    "invocations max_vertices points lines lines_adjacency triangles triangles_adjacency "
    "line_strip triangle_strip gl_MaxGeometryInputComponents gl_MaxGeometryOutputComponents "
    "gl_MaxGeometryOutputVertices gl_MaxGeometryTotalOutputComponents "
    "gl_MaxGeometryUniformComponents gl_MaxGeometryTextureImageUnits";
constexpr std::string_view kGpuShader5 =
    "precise fma bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB "
    "uaddCarry usubBorrow umulExtended imulExtended frexp ldexp textureGather textureGatherOffset "
    "textureGatherOffsets";
constexpr std::string_view kTextureBuffer =
    "samplerBuffer isamplerBuffer usamplerBuffer imageBuffer iimageBuffer uimageBuffer";
constexpr std::string_view kTextureCubeMapArray =
    "samplerCubeArray samplerCubeArrayShadow isamplerCubeArray usamplerCubeArray imageCubeArray "
    "iimageCubeArray uimageCubeArray";

constexpr auto kExtensions = std::to_array<Extension>({
    {"GL_AMD_conservative_depth", 0, kConservativeDepth},
    {"GL_AMD_texture_texture4", 400, "texture4=textureGather"},
    {"GL_ANDROID_extension_pack_es31a", 450,
     "gl_SampleID gl_SamplePosition gl_SampleMask gl_NumSamples gl_SampleMaskIn gl_MaxSamples "
     "imageAtomicAdd imageAtomicMin imageAtomicMax imageAtomicAnd imageAtomicOr imageAtomicXor "
     "imageAtomicExchange imageAtomicCompSwap sample interpolateAtCentroid interpolateAtSample "
     "interpolateAtOffset sampler2DMSArray isampler2DMSArray usampler2DMSArray samplerCubeArray "
     "samplerCubeArrayShadow isamplerCubeArray usamplerCubeArray samplerBuffer isamplerBuffer "
     "usamplerBuffer"},
    {"GL_APPLE_clip_distance", 130, "gl_ClipDistance gl_MaxClipDistances"},
    {"GL_ARB_ES2_compatibility", 410,
     "gl_MaxVertexUniformVectors gl_MaxFragmentUniformVectors gl_MaxVaryingVectors lowp mediump "
     "highp precision"},
    {"GL_ARB_ES3_1_compatibility", 450, "gl_HelperInvocation gl_MaxSamples"},
    {"GL_ARB_ES3_compatibility", 0, ""},
    {"GL_ARB_arrays_of_arrays", 430, ""},
    {"GL_ARB_blend_func_extended", 330, "index"},
    {"GL_ARB_compatibility", 0, ""},
    {"GL_ARB_compute_shader", 430,
     "gl_NumWorkGroups gl_WorkGroupSize gl_WorkGroupID gl_LocalInvocationID gl_GlobalInvocationID "
     "gl_LocalInvocationIndex shared local_size_x local_size_y local_size_z barrier memoryBarrier "
     "memoryBarrierAtomicCounter memoryBarrierBuffer memoryBarrierShared memoryBarrierImage "
     "groupMemoryBarrier"},
    {"GL_ARB_conservative_depth", 0, kConservativeDepth},
    {"GL_ARB_cull_distance", 450, "gl_CullDistance gl_MaxCullDistances gl_MaxCombinedClipAndCullDistances"},
    {"GL_ARB_derivative_control", 450, "dFdxFine dFdyFine fwidthFine dFdxCoarse dFdyCoarse fwidthCoarse"},
    {"GL_ARB_draw_buffers", 0, "gl_FragData gl_MaxDrawBuffers"},
    {"GL_ARB_draw_instanced", 140, "gl_InstanceIDARB=gl_InstanceID"},
    {"GL_ARB_enhanced_layouts", 440, "component align xfb_offset xfb_stride xfb_buffer"},
    {"GL_ARB_explicit_attrib_location", 330, "location index"},
    {"GL_ARB_explicit_uniform_location", 0, "location"},
    {"GL_ARB_fragment_coord_conventions", 150, "origin_upper_left pixel_center_integer"},
    {"GL_ARB_fragment_layer_viewport", 430, "gl_Layer gl_ViewportIndex"},
    {"GL_ARB_fragment_shader", 0, ""},
    {"GL_ARB_geometry_shader4", 0, kGeometryShader4},
    {"GL_ARB_gpu_shader5", 400,
     "precise fma bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB "
     "uaddCarry usubBorrow umulExtended imulExtended frexp ldexp textureGather textureGatherOffset "
     "textureGatherOffsets gl_InvocationID invocations stream EmitStreamVertex EndStreamPrimitive "
     "gl_SampleMaskIn sample interpolateAtCentroid interpolateAtSample interpolateAtOffset "
     "floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat packUnorm2x16 packUnorm4x8 "
     "packSnorm4x8 unpackUnorm2x16 unpackUnorm4x8 unpackSnorm4x8"},
    {"GL_ARB_gpu_shader_fp64", 400,
     "double dvec2 dvec3 dvec4 dmat2 dmat3 dmat4 dmat2x2 dmat2x3 dmat2x4 dmat3x2 dmat3x3 dmat3x4 "
     "dmat4x2 dmat4x3 dmat4x4 packDouble2x32 unpackDouble2x32"},
    {"GL_ARB_sample_shading", 420, "gl_SampleID gl_SamplePosition gl_SampleMask gl_NumSamples"},
    {"GL_ARB_separate_shader_objects", 410, "location"},
    {"GL_ARB_shader_atomic_counters", 420,
     "atomic_uint atomicCounter atomicCounterIncrement atomicCounterDecrement offset binding"},
    {"GL_ARB_shader_bit_encoding", 330, "floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat"},
    {"GL_ARB_shader_image_load_store", 420,
     "imageLoad imageStore imageAtomicAdd imageAtomicMin imageAtomicMax imageAtomicAnd "
     "imageAtomicOr imageAtomicXor imageAtomicExchange imageAtomicCompSwap memoryBarrier "
     "early_fragment_tests coherent volatile restrict readonly writeonly image1D image2D image3D "
     "image2DRect imageCube imageBuffer image1DArray image2DArray imageCubeArray image2DMS "
     "image2DMSArray iimage1D iimage2D iimage3D iimage2DRect iimageCube iimageBuffer iimage1DArray "
     "iimage2DArray iimageCubeArray iimage2DMS iimage2DMSArray uimage1D uimage2D uimage3D "
     "uimage2DRect uimageCube uimageBuffer uimage1DArray uimage2DArray uimageCubeArray uimage2DMS "
     "uimage2DMSArray rgba32f rgba16f rg32f rg16f r11f_g11f_b10f r32f r16f rgba16 rgb10_a2 rgba8 "
     "rg16 rg8 r16 r8 rgba16_snorm rgba8_snorm rg16_snorm rg8_snorm r16_snorm r8_snorm rgba32i "
     "rgba16i rgba8i rg32i rg16i rg8i r32i r16i r8i rgba32ui rgba16ui rgb10_a2ui rgba8ui rg32ui "
     "rg16ui rg8ui r32ui r16ui r8ui"},
    {"GL_ARB_shader_image_size", 430, "imageSize"},
    {"GL_ARB_shader_objects", 0, ""},
    {"GL_ARB_shader_precision", 410, ""},
    {"GL_ARB_shader_storage_buffer_object", 430,
     "buffer std430 atomicAdd atomicMin atomicMax atomicAnd atomicOr atomicXor atomicExchange "
     "atomicCompSwap coherent volatile restrict readonly writeonly"},
    {"GL_ARB_shader_subroutine", 400, "subroutine"},
    {"GL_ARB_shader_texture_image_samples", 450, "textureSamples imageSamples"},
    {"GL_ARB_shader_texture_lod", 130,
     "texture1DLod texture1DProjLod texture2DLod texture2DProjLod texture3DLod texture3DProjLod "
     "textureCubeLod shadow1DLod shadow1DProjLod shadow2DLod shadow2DProjLod texture1DGradARB "
     "texture1DProjGradARB texture2DGradARB texture2DProjGradARB texture3DGradARB "
     "texture3DProjGradARB textureCubeGradARB shadow1DGradARB shadow1DProjGradARB shadow2DGradARB "
     "shadow2DProjGradARB texture2DRectGradARB texture2DRectProjGradARB shadow2DRectGradARB "
     "shadow2DRectProjGradARB"},
    {"GL_ARB_shading_language_100", 0, ""},
    {"GL_ARB_shading_language_420pack", 0, "binding"},
    {"GL_ARB_shading_language_include", 0, ""},
    {"GL_ARB_shading_language_packing", 420,
     "packUnorm2x16 packSnorm2x16 packUnorm4x8 packSnorm4x8 packHalf2x16 unpackUnorm2x16 "
     "unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 unpackHalf2x16"},
    {"GL_ARB_tessellation_shader", 400, kTessellationShader},
    {"GL_ARB_texture_buffer_object", 140, kTextureBufferObject},
    {"GL_ARB_texture_cube_map_array", 400,
     "samplerCubeArray samplerCubeArrayShadow isamplerCubeArray usamplerCubeArray"},
    {"GL_ARB_texture_gather", 400, "textureGather textureGatherOffset"},
    {"GL_ARB_texture_multisample", 150,
     "sampler2DMS isampler2DMS usampler2DMS sampler2DMSArray isampler2DMSArray usampler2DMSArray "
     "texelFetch textureSize"},
    {"GL_ARB_texture_query_levels", 430, "textureQueryLevels"},
    {"GL_ARB_texture_query_lod", 400, "textureQueryLOD"},
    {"GL_ARB_texture_rectangle", 140, kTextureRectangle},
    {"GL_ARB_transform_feedback3", 400, "stream EmitStreamVertex EndStreamPrimitive"},
    {"GL_ARB_uniform_buffer_object", 140, "layout shared packed std140 row_major column_major"},
    {"GL_ARB_vertex_attrib_64bit", 410, kVertexAttrib64bit},
    {"GL_ARB_vertex_shader", 0, ""},
    {"GL_ARB_viewport_array", 410, "gl_ViewportIndex gl_MaxViewports"},
    {"GL_ATI_draw_buffers", 0, "gl_FragData gl_MaxDrawBuffers"},
    {"GL_ATI_shader_texture_lod", 130,
     "texture1DLod texture1DProjLod texture2DLod texture2DProjLod texture3DLod texture3DProjLod "
     "textureCubeLod shadow1DLod shadow1DProjLod shadow2DLod shadow2DProjLod"},
    {"GL_EXT_clip_cull_distance", 450,
     "gl_ClipDistance gl_CullDistance gl_MaxClipDistances gl_MaxCullDistances "
     "gl_MaxCombinedClipAndCullDistances"},
    {"GL_EXT_clip_distance", 130, "gl_ClipDistance gl_MaxClipDistances"},
    {"GL_EXT_conservative_depth", 0, kConservativeDepth},
    {"GL_EXT_cull_distance", 450, "gl_CullDistance gl_MaxCullDistances"},
    {"GL_EXT_draw_buffers", 0, "gl_FragData gl_MaxDrawBuffers"},
    {"GL_EXT_draw_instanced", 140, "gl_InstanceIDEXT=gl_InstanceID"},
    {"GL_EXT_frag_depth", 0, "gl_FragDepthEXT=gl_FragDepth"},
    {"GL_EXT_geometry_point_size", 150, "gl_PointSize"},
    {"GL_EXT_geometry_shader", 400, kGeometryShader},
    {"GL_EXT_geometry_shader4", 0, kGeometryShader4},
    {"GL_EXT_gpu_shader4", 130,
     "flat noperspective centroid unsigned uvec2 uvec3 uvec4 gl_VertexID gl_InstanceID "
     "gl_PrimitiveID truncate=trunc round=roundEven sampler1DArray sampler2DArray "
     "sampler1DArrayShadow sampler2DArrayShadow samplerCubeShadow isampler1D isampler2D isampler3D "
     "isamplerCube isampler2DRect isampler1DArray isampler2DArray usampler1D usampler2D usampler3D "
     "usamplerCube usampler2DRect usampler1DArray usampler2DArray samplerBuffer isamplerBuffer "
     "usamplerBuffer texture1DLod texture1DProjLod texture2DLod texture2DProjLod texture3DLod "
     "texture3DProjLod textureCubeLod shadow1DLod shadow1DProjLod shadow2DLod shadow2DProjLod "
     "texture1DArray texture1DArrayLod texture2DArray texture2DArrayLod shadow1DArray "
     "shadow1DArrayLod shadow2DArray shadowCube texelFetch1D texelFetch2D texelFetch3D "
     "texelFetch2DRect texelFetch1DArray texelFetch2DArray texelFetchBuffer texelFetch1DOffset "
     "texelFetch2DOffset texelFetch3DOffset texelFetch2DRectOffset texelFetch1DArrayOffset "
     "texelFetch2DArrayOffset textureSize1D textureSize2D textureSize3D textureSizeCube "
     "textureSize2DRect textureSize1DArray textureSize2DArray textureSizeBuffer texture1DGrad "
     "texture1DProjGrad texture1DArrayGrad texture2DGrad texture2DProjGrad texture2DArrayGrad "
     "texture3DGrad texture3DProjGrad textureCubeGrad texture2DRectGrad texture2DRectProjGrad "
     "shadow1DGrad shadow1DProjGrad shadow1DArrayGrad shadow2DGrad shadow2DProjGrad "
     "shadow2DArrayGrad shadowCubeGrad shadow2DRectGrad shadow2DRectProjGrad texture1DOffset "
     "texture1DLodOffset texture1DGradOffset texture1DProjOffset texture1DProjLodOffset "
     "texture1DProjGradOffset texture2DOffset texture2DLodOffset texture2DGradOffset "
     "texture2DProjOffset texture2DProjLodOffset texture2DProjGradOffset texture3DOffset "
     "texture3DLodOffset texture3DGradOffset texture3DProjOffset texture3DProjLodOffset "
     "texture3DProjGradOffset shadow1DOffset shadow1DLodOffset shadow1DGradOffset "
     "shadow1DProjOffset shadow1DProjLodOffset shadow1DProjGradOffset shadow2DOffset "
     "shadow2DLodOffset shadow2DGradOffset shadow2DProjOffset shadow2DProjLodOffset "
     "shadow2DProjGradOffset texture2DRectOffset texture2DRectProjOffset texture2DRectGradOffset "
     "texture2DRectProjGradOffset shadow2DRectOffset shadow2DRectProjOffset shadow2DRectGradOffset "
     "shadow2DRectProjGradOffset texture1DArrayOffset texture1DArrayLodOffset "
     "texture1DArrayGradOffset texture2DArrayOffset texture2DArrayLodOffset "
     "texture2DArrayGradOffset shadow1DArrayOffset shadow1DArrayLodOffset shadow1DArrayGradOffset "
     "shadow2DArrayOffset shadow2DArrayGradOffset"},
    {"GL_EXT_gpu_shader5", 400, kGpuShader5},
    {"GL_EXT_separate_shader_objects", 410, "location"},
    {"GL_EXT_shader_image_load_store", 420,
     "imageLoad imageStore imageAtomicAdd imageAtomicMin imageAtomicMax imageAtomicAnd "
     "imageAtomicOr imageAtomicXor imageAtomicExchange imageAtomicCompSwap memoryBarrier "
     "early_fragment_tests coherent volatile restrict image1D image2D image3D image2DRect "
     "imageCube imageBuffer image1DArray image2DArray imageCubeArray image2DMS image2DMSArray "
     "iimage1D iimage2D iimage3D iimage2DRect iimageCube iimageBuffer iimage1DArray iimage2DArray "
     "iimageCubeArray iimage2DMS iimage2DMSArray uimage1D uimage2D uimage3D uimage2DRect "
     "uimageCube uimageBuffer uimage1DArray uimage2DArray uimageCubeArray uimage2DMS "
     "uimage2DMSArray +imageAtomicIncWrap +imageAtomicDecWrap +size1x8 +size1x16 +size1x32 "
     "+size2x32 +size4x32"},
    {"GL_EXT_shader_implicit_conversions", 400, ""},
    {"GL_EXT_shader_integer_mix", 450, "mix"},
    {"GL_EXT_shader_io_blocks", 150, "gl_PerVertex"},
    {"GL_EXT_shader_non_constant_global_initializers", 110, ""},
    {"GL_EXT_shader_texture_lod", 130,
     "texture2DLodEXT texture2DProjLodEXT textureCubeLodEXT texture2DGradEXT texture2DProjGradEXT "
     "textureCubeGradEXT"},
    {"GL_EXT_shader_texture_samples", 450, "textureSamples"},
    {"GL_EXT_shadow_samplers", 130, "sampler2DShadow shadow2DEXT shadow2DProjEXT"},
    {"GL_EXT_tessellation_point_size", 400, "gl_PointSize"},
    {"GL_EXT_tessellation_shader", 400, kTessellationShader},
    {"GL_EXT_texture_array", 130,
     "sampler1DArray sampler2DArray sampler1DArrayShadow sampler2DArrayShadow texture1DArray "
     "texture1DArrayLod texture2DArray texture2DArrayLod shadow1DArray shadow1DArrayLod "
     "shadow2DArray"},
    {"GL_EXT_texture_buffer", 420, kTextureBuffer},
    {"GL_EXT_texture_buffer_object", 140, kTextureBufferObject},
    {"GL_EXT_texture_cube_map_array", 420, kTextureCubeMapArray},
    {"GL_EXT_texture_integer", 130, ""},
    {"GL_EXT_texture_norm16", 420, "r16 rg16 rgba16 r16_snorm rg16_snorm rgba16_snorm"},
    {"GL_EXT_texture_query_lod", 400, "textureQueryLOD"},
    {"GL_EXT_texture_rectangle", 140, kTextureRectangle},
    {"GL_EXT_transform_feedback", 130, ""},
    {"GL_EXT_vertex_attrib_64bit", 410, kVertexAttrib64bit},
    {"GL_GOOGLE_include_directive", 0, ""},
    {"GL_MESA_shader_integer_functions", 400,
     "bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB uaddCarry usubBorrow "
     "umulExtended imulExtended frexp ldexp"},
    {"GL_NV_draw_buffers", 0, "gl_FragData gl_MaxDrawBuffers"},
    {"GL_NV_draw_instanced", 140, "gl_InstanceIDNV=gl_InstanceID"},
    {"GL_NV_explicit_attrib_location", 330, "layout location"},
    {"GL_NV_gpu_shader5", 400,
     "int32_t=int uint32_t=uint float32_t=float float64_t=double i32vec2=ivec2 i32vec3=ivec3 "
     "i32vec4=ivec4 u32vec2=uvec2 u32vec3=uvec3 u32vec4=uvec4 f32vec2=vec2 f32vec3=vec3 "
     "f32vec4=vec4 f64vec2=dvec2 f64vec3=dvec3 f64vec4=dvec4 +int8_t +int16_t +int64_t +uint8_t "
     "+uint16_t +uint64_t +float16_t +i8vec2 +i8vec3 +i8vec4 +i16vec2 +i16vec3 +i16vec4 +i64vec2 "
     "+i64vec3 +i64vec4 +u8vec2 +u8vec3 +u8vec4 +u16vec2 +u16vec3 +u16vec4 +u64vec2 +u64vec3 "
     "+u64vec4 +f16vec2 +f16vec3 +f16vec4 +packInt2x32 +unpackInt2x32 +packUint2x32 "
     "+unpackUint2x32 +packFloat2x16 +unpackFloat2x16 +doubleBitsToInt64 +doubleBitsToUint64 "
     "+int64BitsToDouble +uint64BitsToDouble +anyThreadNV +allThreadsNV +allThreadsEqualNV"},
    {"GL_NV_image_formats", 420,
     "rgba32f rgba16f rg32f rg16f r11f_g11f_b10f r32f r16f rgba16 rgb10_a2 rgba8 rg16 rg8 r16 r8 "
     "rgba16_snorm rgba8_snorm rg16_snorm rg8_snorm r16_snorm r8_snorm rgba32i rgba16i rgba8i "
     "rg32i rg16i rg8i r32i r16i r8i rgba32ui rgba16ui rgb10_a2ui rgba8ui rg32ui rg16ui rg8ui "
     "r32ui r16ui r8ui"},
    {"GL_NV_non_square_matrices", 120, "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4"},
    {"GL_NV_shader_noperspective_interpolation", 130, "noperspective"},
    {"GL_NV_shadow_samplers_array", 130, "sampler2DArrayShadowNV=sampler2DArrayShadow shadow2DArrayNV"},
    {"GL_NV_shadow_samplers_cube", 130, "samplerCubeShadowNV=samplerCubeShadow shadowCubeNV"},
    {"GL_NV_texture_array", 130, "sampler2DArrayNV=sampler2DArray texture2DArrayNV texture2DArrayLodNV"},
    {"GL_NV_viewport_array", 410, "gl_ViewportIndex gl_MaxViewports"},
    {"GL_OES_fragment_precision_high", 0, ""},
    {"GL_OES_geometry_point_size", 150, "gl_PointSize"},
    {"GL_OES_geometry_shader", 400, kGeometryShader},
    {"GL_OES_gpu_shader5", 400, kGpuShader5},
    {"GL_OES_sample_variables", 450,
     "gl_SampleID gl_SamplePosition gl_SampleMask gl_NumSamples gl_SampleMaskIn gl_MaxSamples"},
    {"GL_OES_shader_image_atomic", 420,
     "imageAtomicAdd imageAtomicMin imageAtomicMax imageAtomicAnd imageAtomicOr imageAtomicXor "
     "imageAtomicExchange imageAtomicCompSwap"},
    {"GL_OES_shader_io_blocks", 150, "gl_PerVertex"},
    {"GL_OES_shader_multisample_interpolation", 400,
     "sample interpolateAtCentroid interpolateAtSample interpolateAtOffset"},
    {"GL_OES_standard_derivatives", 0, "dFdx dFdy fwidth"},
    {"GL_OES_tessellation_point_size", 400, "gl_PointSize"},
    {"GL_OES_tessellation_shader", 400, kTessellationShader},
    {"GL_OES_texture_3D", 0, "sampler3D texture3D texture3DProj texture3DLod texture3DProjLod"},
    {"GL_OES_texture_buffer", 420, kTextureBuffer},
    {"GL_OES_texture_cube_map_array", 420, kTextureCubeMapArray},
    {"GL_OES_texture_storage_multisample_2d_array", 150,
     "sampler2DMSArray isampler2DMSArray usampler2DMSArray"},
    {"GL_OES_viewport_array", 410, "gl_ViewportIndex gl_MaxViewports"},
});

/// A word of the table that is not simply a word of the core profile, and where it comes from.
struct Word {
    const Extension* extension;
    std::string_view core;  ///< what it becomes; empty: only the extension itself has it
};

const std::unordered_multimap<std::string_view, Word>& words() {
    static const auto kWords = [] {
        std::unordered_multimap<std::string_view, Word> table;
        for (const Extension& each : kExtensions)
            for (const std::string_view word : splitWords(each.adds)) {
                if (word.starts_with('+'))
                    table.emplace(word.substr(1), Word{&each, {}});
                else if (const std::size_t equals = word.find('='); equals != std::string_view::npos)
                    table.emplace(word.substr(0, equals), Word{&each, word.substr(equals + 1)});
            }
        return table;
    }();
    return kWords;
}

}  // namespace

std::span<const Extension> extensions() {
    return kExtensions;
}

const Extension* findExtension(std::string_view name) {
    const auto* const found =
        std::ranges::find_if(kExtensions, [&](const Extension& row) { return row.name == name; });
    return found == kExtensions.end() ? nullptr : found;
}

bool isInCore(std::string_view name, int version) {
    const Extension* const row = findExtension(name);
    return row != nullptr && row->since <= version;
}

std::string_view coreWordOf(std::string_view word, const ExtensionNames& enabled) {
    const auto [first, last] = words().equal_range(word);
    for (auto each = first; each != last; ++each)
        if (enabled.contains(each->second.extension->name) || word.starts_with("gl_"))
            return each->second.core;
    return {};
}

const Extension* extensionThatAlone(std::string_view word, const ExtensionNames& enabled) {
    const auto [first, last] = words().equal_range(word);
    for (auto each = first; each != last; ++each)
        if (each->second.core.empty() && enabled.contains(each->second.extension->name))
            return each->second.extension;
    return nullptr;
}

}  // namespace glibra::glsl
