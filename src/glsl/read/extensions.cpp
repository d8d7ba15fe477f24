#include "glsl/read/extensions.h"

#include <algorithm>
#include <array>

namespace glibra::glsl {
namespace {

struct ExtensionRow {
    std::string_view name;
    int version;
};

constexpr std::array kExtensions = std::to_array<ExtensionRow>({
    {"GL_ARB_arrays_of_arrays", 430},
    {"GL_ARB_compatibility", 0},
    {"GL_ARB_conservative_depth", 420},
    {"GL_ARB_cull_distance", 450},
    {"GL_ARB_derivative_control", 450},
    {"GL_ARB_draw_buffers", 0},
    {"GL_ARB_draw_instanced", 140},
    {"GL_ARB_enhanced_layouts", 440},
    {"GL_ARB_ES2_compatibility", 410},
    {"GL_ARB_ES3_compatibility", 430},
    {"GL_ARB_ES3_1_compatibility", 450},
    {"GL_ARB_explicit_attrib_location", 330},
    {"GL_ARB_explicit_uniform_location", 430},
    {"GL_ARB_fragment_coord_conventions", 150},
    {"GL_ARB_fragment_layer_viewport", 430},
    {"GL_ARB_geometry_shader4", 0},
    {"GL_ARB_gpu_shader5", 400},
    {"GL_ARB_gpu_shader_fp64", 400},
    {"GL_ARB_separate_shader_objects", 410},
    {"GL_ARB_shader_atomic_counters", 420},
    {"GL_ARB_shader_bit_encoding", 330},
    {"GL_ARB_shader_image_load_store", 420},
    {"GL_ARB_shader_image_size", 430},
    {"GL_ARB_shader_objects", 0},
    {"GL_ARB_shader_precision", 410},
    {"GL_ARB_shader_storage_buffer_object", 430},
    {"GL_ARB_shader_subroutine", 400},
    {"GL_ARB_shader_texture_image_samples", 450},
    {"GL_ARB_shader_texture_lod", 130},
    {"GL_ARB_shading_language_100", 0},
    {"GL_ARB_shading_language_420pack", 420},
    {"GL_ARB_shading_language_include", 0},
    {"GL_ARB_shading_language_packing", 420},
    {"GL_ARB_tessellation_shader", 400},
    {"GL_ARB_texture_buffer_object", 140},
    {"GL_ARB_texture_cube_map_array", 400},
    {"GL_ARB_texture_gather", 400},
    {"GL_ARB_texture_multisample", 150},
    {"GL_ARB_texture_query_levels", 430},
    {"GL_ARB_texture_query_lod", 400},
    {"GL_ARB_texture_rectangle", 140},
    {"GL_ARB_uniform_buffer_object", 140},
    {"GL_ARB_vertex_attrib_64bit", 410},
    {"GL_ARB_viewport_array", 410},
    {"GL_EXT_draw_instanced", 140},
    {"GL_EXT_frag_depth", 0},
    {"GL_EXT_geometry_shader", 150},
    {"GL_EXT_geometry_shader4", 0},
    {"GL_EXT_gpu_shader4", 130},
    {"GL_EXT_gpu_shader5", 400},
    {"GL_EXT_separate_shader_objects", 410},
    {"GL_EXT_shader_image_load_store", 420},
    {"GL_EXT_shader_io_blocks", 150},
    {"GL_EXT_shader_texture_lod", 130},
    {"GL_EXT_tessellation_shader", 400},
    {"GL_EXT_texture_array", 130},
    {"GL_EXT_texture_buffer_object", 140},
    {"GL_EXT_texture_cube_map_array", 400},
    {"GL_EXT_texture_integer", 130},
    {"GL_EXT_texture_rectangle", 140},
    {"GL_EXT_transform_feedback", 130},
    {"GL_EXT_Cg_shader", 0},
    {"GL_NV_gpu_shader5", 400},
    {"GL_NV_shadow_samplers_cube", 130},
    {"GL_OES_standard_derivatives", 0},
    {"GL_OES_texture_3D", 0},
});

}  // namespace

std::optional<int> extensionInCoreSince(std::string_view name) {
    const auto* const found = std::find_if(kExtensions.begin(), kExtensions.end(),
                                           [&](const ExtensionRow& row) { return row.name == name; });
    if (found == kExtensions.end()) return std::nullopt;
    return found->version;
}

}  // namespace glibra::glsl
