// Every accepted extension is required by a shader that uses each word which the extension adds, in the form
// that the extension's text in Khronos' registry gives it. glslangValidator compiles what the translation
// makes of it.

#include "glsl/read/extensions.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <set>

#include "support.h"

namespace glibra::glsl::test {
namespace {

/// How a shader uses a word: in which stage, with which declaration and statement. `r` is a vec4.
struct WordUse {
    Stage stage = Stage::fragment;
    std::string declaration;
    std::string statement;
};

bool startsWith(std::string_view text, std::string_view part) {
    return text.substr(0, part.size()) == part;
}
bool hasPart(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

std::string vectorWord(int size, const std::string& prefix, const std::string& scalar) {
    return size == 1 ? scalar : prefix + "vec" + std::to_string(size);
}
std::string floatsOf(int size) {
    return vectorWord(size, "", "float") + "(.5)";
}
std::string intsOf(int size) {
    return vectorWord(size, "i", "int") + "(1)";
}

/// What a texture function of GLSL 1.x takes, by its name (EXT_gpu_shader4, 8.7).
struct TextureDimension {
    std::string_view name;
    int coordinates, derivatives, shadow;
};
constexpr TextureDimension kTextureDimensions[] = {
    {"2DRect", 2, 2, 3}, {"1DArray", 2, 1, 3}, {"2DArray", 3, 2, 4}, {"Buffer", 1, 1, 0},
    {"Cube", 3, 3, 4},   {"1D", 1, 1, 3},      {"2D", 2, 2, 3},      {"3D", 3, 3, 0}};

std::optional<WordUse> textureUse(std::string_view word) {
    std::string_view rest = word;
    std::string_view kind;
    for (const std::string_view each : {"textureSize", "texelFetch", "texture", "shadow"})
        if (kind.empty() && startsWith(rest, each)) kind = each;
    if (kind.empty()) return std::nullopt;
    rest.remove_prefix(kind.size());
    const TextureDimension* dimension = nullptr;
    for (const TextureDimension& each : kTextureDimensions)
        if (dimension == nullptr && startsWith(rest, each.name)) dimension = &each;
    if (dimension == nullptr) return std::nullopt;
    rest.remove_prefix(dimension->name.size());
    const bool isShadow = kind == "shadow", isRect = dimension->name == "2DRect";
    const bool isNvidia = rest.ends_with("NV");
    std::string sampler = "sampler" + std::string(dimension->name) + (isShadow ? "Shadow" : "");
    if (isNvidia) sampler += "NV";
    const std::string name = "the_" + sampler;
    std::string call = std::string(word) + "(" + name;
    if (kind == "textureSize") {
        if (dimension->name != "Buffer") call += ", 0";
        const bool isScalar = dimension->name == "Buffer" || dimension->name == "1D";
        return WordUse{Stage::fragment, "uniform " + sampler + " " + name + ";",
                       "r.x += float(" + call + ")" + (isScalar ? "" : ".x") + ");"};
    }
    const std::string offset =
        dimension->derivatives == 1 ? "2" : "ivec" + std::to_string(dimension->derivatives) + "(2)";
    if (kind == "texelFetch") {
        call += ", " + intsOf(dimension->coordinates);
        if (!isRect && dimension->name != "Buffer") call += ", 0";
    } else if (isShadow) {
        call += ", " + floatsOf(hasPart(rest, "Proj") ? 4 : dimension->shadow);
    } else {
        call += ", " + floatsOf(dimension->coordinates + (hasPart(rest, "Proj") ? 1 : 0));
    }
    if (hasPart(rest, "Lod")) call += ", 1.";
    for (int i = 0; i < 2 && hasPart(rest, "Grad"); ++i) call += ", " + floatsOf(dimension->derivatives);
    if (hasPart(rest, "Offset")) call += ", " + offset;
    return WordUse{Stage::fragment, "uniform " + sampler + " " + name + ";", "r += vec4(" + call + "));"};
}

/// Types, constants and formats of images.
std::optional<WordUse> typeUse(const std::string& word) {
    if (hasPart(word, "sampler")) return WordUse{Stage::fragment, "uniform " + word + " t" + word + ";", ""};
    const std::string bare = startsWith(word, "i") && !startsWith(word, "image") ? word.substr(1)
                             : startsWith(word, "u")                             ? word.substr(1)
                                                                                 : word;
    const std::string number = "8" + std::string(word == bare ? "" : word.substr(0, 1) == "i" ? "i" : "ui");
    if (startsWith(bare, "image") && bare.size() > 5 &&
        (bare[5] == '1' || bare[5] == '2' || bare[5] == '3' || bare == "imageCube" || bare == "imageBuffer" ||
         bare == "imageCubeArray"))
        return WordUse{Stage::fragment, "layout(rgba" + number + ") uniform " + word + " t" + word + ";", ""};
    if (startsWith(word, "gl_Max")) return WordUse{Stage::fragment, "", "r.x += float(" + word + ");"};
    const bool isMatrix = hasPart(word, "mat") && word.size() <= 7 && word != "format";
    const bool isVector = hasPart(word, "vec") && word.size() <= 7;
    if (isMatrix || isVector || word == "double" || word.ends_with("2_t") || word == "float64_t")
        return WordUse{Stage::fragment, "",
                       "{ " + word + " v = " + word + "(1" + (startsWith(word, "u") ? "u" : "") +
                           "); r.x += float(v" +
                           (isMatrix   ? "[0][0]"
                            : isVector ? "[0]"
                                       : "") +
                           "); }"};
    static const std::set<std::string, std::less<>> kFormats = [] {
        std::set<std::string, std::less<>> all;
        for (const char* const channels : {"r", "rg", "rgba"})
            for (const char* const kind :
                 {"32f", "16f", "16", "8", "16_snorm", "8_snorm", "32i", "16i", "8i", "32ui", "16ui", "8ui"})
                all.insert(std::string(channels) + kind);
        all.insert({"r11f_g11f_b10f", "rgb10_a2", "rgb10_a2ui"});
        return all;
    }();
    if (kFormats.contains(word)) {
        const std::string kind = word.ends_with("ui") ? "u" : word.ends_with("i") ? "i" : "";
        return WordUse{Stage::fragment, "layout(" + word + ") uniform " + kind + "image2D f" + word + ";",
                       ""};
    }
    return std::nullopt;
}

const std::map<std::string, WordUse>& otherUses() {
    constexpr Stage v = Stage::vertex, f = Stage::fragment, g = Stage::geometry, c = Stage::tessControl,
                    e = Stage::tessEvaluation, k = Stage::compute;
    static const std::map<std::string, WordUse> kUses = [] {
        std::map<std::string, WordUse> all = {
            {"gl_InstanceIDARB", {v, "", "r.x += float(gl_InstanceIDARB);"}},
            {"gl_InstanceIDEXT", {v, "", "r.x += float(gl_InstanceIDEXT);"}},
            {"gl_InstanceIDNV", {v, "", "r.x += float(gl_InstanceIDNV);"}},
            {"gl_InstanceID", {v, "", "r.x += float(gl_InstanceID);"}},
            {"gl_VertexID", {v, "", "r.x += float(gl_VertexID);"}},
            {"gl_FragDepthEXT", {f, "", "gl_FragDepthEXT = .5;"}},
            {"gl_FragData", {f, "", "gl_FragData[1] = r;"}},
            {"gl_ClipDistance", {v, "out float gl_ClipDistance[2];", "gl_ClipDistance[1] = 1.;"}},
            {"gl_CullDistance", {v, "out float gl_CullDistance[2];", "gl_CullDistance[1] = 1.;"}},
            {"gl_HelperInvocation", {f, "", "if (gl_HelperInvocation) r.x += 1.;"}},
            {"gl_SampleID", {f, "", "r.x += float(gl_SampleID);"}},
            {"gl_SamplePosition", {f, "", "r.xy += gl_SamplePosition;"}},
            {"gl_SampleMask", {f, "", "gl_SampleMask[0] = 1;"}},
            {"gl_SampleMaskIn", {f, "", "r.x += float(gl_SampleMaskIn[0]);"}},
            {"gl_NumSamples", {f, "", "r.x += float(gl_NumSamples);"}},
            {"gl_ViewportIndex", {f, "", "r.x += float(gl_ViewportIndex);"}},
            {"depth_any", {f, "layout(depth_any) out float gl_FragDepth;", "gl_FragDepth = .5;"}},
            {"depth_greater", {f, "", ""}},  // one redeclaration in a shader: the words are
            {"depth_less", {f, "", ""}},     // tried one by one below
            {"depth_unchanged", {f, "", ""}},
            {"origin_upper_left",
             {f, "layout(origin_upper_left, pixel_center_integer) in vec4 gl_FragCoord;",
              "r += gl_FragCoord;"}},
            {"pixel_center_integer", {f, "", ""}},
            {"component",
             {v, "layout(location = 1, component = 2) out vec2 vComponent;", "vComponent = r.xy;"}},
            {"align",
             {f, "layout(std140) uniform Aligned { float a; layout(align = 32) float b; };",
              "r.x += a + b;"}},
            {"xfb_offset",
             {v, "layout(xfb_buffer = 0, xfb_stride = 16) out; layout(xfb_offset = 0) out vec4 vCaptured;",
              "vCaptured = r;"}},
            {"xfb_stride", {v, "", ""}},
            {"xfb_buffer", {v, "", ""}},
            {"index", {f, "", ""}},  // of outputs for blending with two colours, tried below
            {"location", {v, "layout(location = 3) in vec4 aLocated;", "r += aLocated;"}},
            {"layout", {v, "", ""}},
            {"binding",
             {f, "layout(binding = 2) uniform sampler2D uBound;", "r += texture2D(uBound, vec2(.5));"}},
            {"lowp", {f, "precision lowp int;", ""}},
            {"mediump", {f, "mediump float uMedium = .5;", ""}},
            {"highp", {f, "", "highp float high = 1.; r.x += high;"}},
            {"precision", {f, "precision highp float;", ""}},
            {"flat", {v, "flat varying vec4 vFlat;", "vFlat = r;"}},
            {"noperspective", {v, "noperspective varying vec4 vLinear; ", "vLinear = r;"}},
            {"centroid",
             {v, "centroid varying vec4 vCentroid; centroid noperspective varying vec2 vBoth;",
              "vCentroid = r; vBoth = r.xy;"}},
            {"unsigned",
             {v,
              "attribute unsigned int aMask; flat varying unsigned int vMask; unsigned int twice(unsigned "
              "int a) { return a << 1; }",
              "unsigned int k = 6u; vMask = twice(aMask) % k | ~k;"}},
            {"truncate", {f, "", "r += truncate(r);"}},
            {"round", {f, "", "r += round(r);"}},
            {"dFdx", {f, "", "r += dFdx(r);"}},
            {"dFdy", {f, "", "r += dFdy(r);"}},
            {"fwidth", {f, "", "r += fwidth(r);"}},
            {"texture4", {f, "uniform sampler2D uFour;", "r += texture4(uFour, vec2(.5));"}},
            {"texelFetch", {f, "uniform sampler2DMS uSamples;", "r += texelFetch(uSamples, ivec2(0), 1);"}},
            {"textureSize", {f, "uniform sampler2DMS uSize;", "r.x += float(textureSize(uSize).x);"}},
            {"textureQueryLOD", {f, "uniform sampler2D uLod;", "r.xy += textureQueryLOD(uLod, vec2(.5));"}},
            {"textureQueryLevels",
             {f, "uniform sampler2D uLevels;", "r.x += float(textureQueryLevels(uLevels));"}},
            {"textureSamples", {f, "uniform sampler2DMS uMany;", "r.x += float(textureSamples(uMany));"}},
            {"imageSamples",
             {f, "layout(rgba8) uniform image2DMS iMany;", "r.x += float(imageSamples(iMany));"}},
            {"imageSize", {f, "layout(rgba8) uniform image2D iSize;", "r.x += float(imageSize(iSize).x);"}},
            {"textureGather", {f, "uniform sampler2D uGather;", "r += textureGather(uGather, vec2(.5));"}},
            {"textureGatherOffset",
             {f, "uniform sampler2D uGatherOne;",
              "r += textureGatherOffset(uGatherOne, vec2(.5), ivec2(1));"}},
            {"textureGatherOffsets",
             {f,
              "uniform sampler2D uGatherMany; const ivec2 offsets[4] = ivec2[4](ivec2(0), ivec2(1), "
              "ivec2(2), ivec2(3));",
              "r += textureGatherOffsets(uGatherMany, vec2(.5), offsets);"}},
            {"precise", {f, "", "precise float exact = r.x * r.y; r.x += exact;"}},
            {"fma", {f, "", "r = fma(r, r, r);"}},
            {"mix", {f, "", "r.x += float(mix(1, 2, r.x > 0.));"}},
            {"bitfieldExtract", {f, "", "r.x += float(bitfieldExtract(7, 1, 2));"}},
            {"bitfieldInsert", {f, "", "r.x += float(bitfieldInsert(7, 1, 2, 3));"}},
            {"uaddCarry", {f, "", "{ uint carry; r.x += float(uaddCarry(1u, 2u, carry)); }"}},
            {"usubBorrow", {f, "", "{ uint borrow; r.x += float(usubBorrow(1u, 2u, borrow)); }"}},
            {"umulExtended", {f, "", "{ uint a, b; umulExtended(1u, 2u, a, b); }"}},
            {"imulExtended", {f, "", "{ int a, b; imulExtended(1, 2, a, b); }"}},
            {"frexp", {f, "", "{ int power; r.x += frexp(r.x, power); }"}},
            {"ldexp", {f, "", "r.x = ldexp(r.x, 2);"}},
            {"floatBitsToInt", {f, "", "r.x += float(floatBitsToInt(r.x));"}},
            {"floatBitsToUint", {f, "", "r.x += float(floatBitsToUint(r.x));"}},
            {"intBitsToFloat", {f, "", "r.x += intBitsToFloat(1);"}},
            {"uintBitsToFloat", {f, "", "r.x += uintBitsToFloat(1u);"}},
            {"packDouble2x32", {f, "", "r.x += float(packDouble2x32(uvec2(1u)));"}},
            {"unpackDouble2x32", {f, "", "r.x += float(unpackDouble2x32(double(1.)).x);"}},
            {"sample", {f, "sample in vec4 vSample;", "r += vSample;"}},
            {"interpolateAtCentroid", {f, "in vec4 vAt;", "r += interpolateAtCentroid(vAt);"}},
            {"interpolateAtSample", {f, "in vec4 vAtSample;", "r += interpolateAtSample(vAtSample, 0);"}},
            {"interpolateAtOffset",
             {f, "in vec4 vAtOffset;", "r += interpolateAtOffset(vAtOffset, vec2(.1));"}},
            {"dFdxFine", {f, "", "r += dFdxFine(r) + dFdyFine(r) + fwidthFine(r);"}},
            {"dFdyFine", {f, "", ""}},
            {"fwidthFine", {f, "", ""}},
            {"dFdxCoarse", {f, "", "r += dFdxCoarse(r) + dFdyCoarse(r) + fwidthCoarse(r);"}},
            {"dFdyCoarse", {f, "", ""}},
            {"fwidthCoarse", {f, "", ""}},
            {"imageLoad", {f, "layout(rgba8) uniform image2D iLoad;", "r += imageLoad(iLoad, ivec2(0));"}},
            {"imageStore", {f, "layout(rgba8) uniform image2D iStore;", "imageStore(iStore, ivec2(0), r);"}},
            {"memoryBarrier", {f, "", "memoryBarrier();"}},
            {"early_fragment_tests", {f, "layout(early_fragment_tests) in;", ""}},
            {"coherent", {f, "layout(rgba8) coherent uniform image2D iCoherent;", ""}},
            {"volatile", {f, "layout(rgba8) volatile uniform image2D iVolatile;", ""}},
            {"restrict", {f, "layout(rgba8) restrict uniform image2D iRestrict;", ""}},
            {"readonly", {f, "layout(rgba8) readonly uniform image2D iReadonly;", ""}},
            {"writeonly", {f, "writeonly uniform image2D iWriteonly;", ""}},
            {"atomic_uint",
             {f, "layout(binding = 0, offset = 4) uniform atomic_uint counter;",
              "r.x += float(atomicCounter(counter) + atomicCounterIncrement(counter) + "
              "atomicCounterDecrement(counter));"}},
            {"atomicCounter", {f, "", ""}},
            {"atomicCounterIncrement", {f, "", ""}},
            {"atomicCounterDecrement", {f, "", ""}},
            {"offset", {f, "", ""}},
            {"buffer", {f, "layout(std430) buffer Data { uint total; };", ""}},
            {"std430", {f, "", ""}},
            {"subroutine",
             {f,
              "subroutine float Shade(float x); subroutine(Shade) float twice(float x) { return 2. * x; } "
              "subroutine uniform Shade shade;",
              "r.x = shade(r.x);"}},
            {"shared", {f, "layout(shared) uniform SharedBlock { vec4 s; };", "r += s;"}},
            {"packed", {f, "layout(packed) uniform PackedBlock { vec4 p; };", "r += p;"}},
            {"std140", {f, "layout(std140) uniform StandardBlock { vec4 q; };", "r += q;"}},
            {"row_major", {f, "layout(row_major) uniform RowBlock { mat4 m; };", "r *= m;"}},
            {"column_major", {f, "layout(column_major) uniform ColumnBlock { mat4 n; };", "r *= n;"}},
            {"gl_PerVertex", {v, "out gl_PerVertex { vec4 gl_Position; };", ""}},
            {"stream", {g, "layout(stream = 0) out vec4 gStream;", "gStream = r;"}},
            {"EmitStreamVertex", {g, "", "EmitStreamVertex(0);"}},
            {"EndStreamPrimitive", {g, "", "EndStreamPrimitive(0);"}},
            {"invocations", {g, "layout(invocations = 2) in;", ""}},
            {"gl_InvocationID", {g, "", "r.x += float(gl_InvocationID);"}},
            {"gl_PrimitiveIDIn", {g, "", "r.x += float(gl_PrimitiveIDIn);"}},
            {"gl_PrimitiveID", {f, "", "r.x += float(gl_PrimitiveID);"}},
            {"gl_Layer", {g, "", "gl_Layer = 1;"}},
            {"gl_PointSize", {g, "", "gl_PointSize = 1.;"}},
            {"gl_in", {g, "", "r += gl_in[0].gl_Position;"}},
            {"gl_VerticesIn",
             {g, "varying in vec4 vOld[gl_VerticesIn];",
              "for (int i = 0; i < gl_VerticesIn; i++) r += vOld[i];"}},
            {"gl_PositionIn", {g, "", "r += gl_PositionIn[1];"}},
            {"gl_PointSizeIn", {g, "", "r.x += gl_PointSizeIn[1];"}},
            {"gl_TexCoordIn", {g, "", "r += gl_TexCoordIn[1][0];"}},
            {"gl_FogFragCoordIn", {g, "", "r.x += gl_FogFragCoordIn[1];"}},
            {"gl_ClipVertexIn", {g, "", ""}},  // refused by a message of its own (language, 7.12)
            {"EmitVertex", {g, "", "EmitVertex();"}},
            {"EndPrimitive", {g, "", "EndPrimitive();"}},
            {"patch", {c, "patch out vec4 tPatch;", "tPatch = r;"}},
            {"gl_out", {c, "", "gl_out[gl_InvocationID].gl_Position = gl_in[0].gl_Position;"}},
            {"gl_PatchVerticesIn", {c, "", "r.x += float(gl_PatchVerticesIn);"}},
            {"gl_TessLevelOuter", {c, "", "gl_TessLevelOuter[0] = 1.;"}},
            {"gl_TessLevelInner", {c, "", "gl_TessLevelInner[0] = 1.;"}},
            {"barrier", {c, "", "barrier();"}},
            {"gl_TessCoord", {e, "", "r.xyz += gl_TessCoord;"}},
            {"memoryBarrierAtomicCounter",
             {k, "",
              "memoryBarrierAtomicCounter(); memoryBarrierBuffer(); memoryBarrierShared(); "
              "memoryBarrierImage(); groupMemoryBarrier();"}},
            {"gl_NumWorkGroups",
             {k, "",
              "r.x += float(gl_NumWorkGroups.x + gl_WorkGroupSize.x + gl_WorkGroupID.x + "
              "gl_LocalInvocationID.x + gl_GlobalInvocationID.x + gl_LocalInvocationIndex);"}},
        };
        for (const char* const word : {"bitfieldReverse", "bitCount", "findLSB", "findMSB"})
            all[word] = {f, "", "r.x += float(" + std::string(word) + "(7));"};
        for (const char* const word :
             {"gl_FrontColorIn", "gl_BackColorIn", "gl_FrontSecondaryColorIn", "gl_BackSecondaryColorIn"})
            all[word] = {g, "", "r += " + std::string(word) + "[0];"};
        for (const char* const word : {"packUnorm2x16", "packSnorm2x16", "packHalf2x16"}) {
            all[word] = {f, "", "r.x += float(" + std::string(word) + "(r.xy));"};
            all["un" + std::string(word)] = {f, "", "r.xy += un" + std::string(word) + "(1u);"};
        }
        for (const char* const word : {"packUnorm4x8", "packSnorm4x8"}) {
            all[word] = {f, "", "r.x += float(" + std::string(word) + "(r));"};
            all["un" + std::string(word)] = {f, "", "r += un" + std::string(word) + "(1u);"};
        }
        for (const char* const word : {"Add", "Min", "Max", "And", "Or", "Xor", "Exchange", "CompSwap"}) {
            const std::string name(word);
            const std::string compared = name == "CompSwap" ? "1u, " : "";
            all["imageAtomic" + name] = {
                f, "layout(r32ui) uniform uimage2D iAtomic;",
                "r.x += float(imageAtomic" + name + "(iAtomic, ivec2(0), " + compared + "2u));"};
            all["atomic" + name] = {f, "", "r.x += float(atomic" + name + "(total, " + compared + "2u));"};
        }
        for (const char* const word :
             {"memoryBarrierBuffer", "memoryBarrierShared", "memoryBarrierImage", "groupMemoryBarrier",
              "gl_WorkGroupSize", "gl_WorkGroupID", "gl_LocalInvocationID", "gl_GlobalInvocationID",
              "gl_LocalInvocationIndex", "local_size_x", "local_size_y", "local_size_z"})
            all[word] = {k, "", ""};  // together with the others
        // Words of layouts that every shader of the stage below has, or that the next test tries one by one.
        for (const char* const word : {"max_vertices", "points", "lines", "lines_adjacency", "triangles",
                                       "triangles_adjacency", "line_strip", "triangle_strip"})
            all[word] = {g, "", ""};
        for (const char* const word :
             {"vertices", "quads", "isolines", "equal_spacing", "fractional_even_spacing",
              "fractional_odd_spacing", "cw", "ccw", "point_mode"})
            all[word] = {e, "", ""};
        return all;
    }();
    return kUses;
}

std::optional<WordUse> useOf(const std::string& word) {
    if (const auto found = otherUses().find(word); found != otherUses().end()) return found->second;
    if (auto use = textureUse(word)) return use;
    return typeUse(word);
}

/// The version whose shaders the extension was written for.
std::string dialectOf(std::string_view name) {
    const auto isIn = [&](std::string_view list) {
        return (" " + std::string(list) + " ").find(" " + std::string(name.substr(3)) + " ") !=
               std::string::npos;
    };
    if (isIn("EXT_draw_buffers EXT_frag_depth EXT_shader_texture_lod EXT_shadow_samplers NV_draw_buffers "
             "NV_draw_instanced "
             "EXT_draw_instanced NV_explicit_attrib_location NV_non_square_matrices NV_shadow_samplers_array "
             "NV_shadow_samplers_cube NV_texture_array OES_fragment_precision_high OES_standard_derivatives "
             "OES_texture_3D"))
        return "100";
    if (isIn("EXT_clip_cull_distance EXT_clip_distance EXT_cull_distance EXT_conservative_depth "
             "EXT_shader_integer_mix "
             "EXT_shader_non_constant_global_initializers NV_shader_noperspective_interpolation "
             "APPLE_clip_distance"))
        return "300 es";
    if (startsWith(name, "GL_OES") || startsWith(name, "GL_ANDROID") ||
        isIn("EXT_geometry_shader EXT_geometry_point_size EXT_gpu_shader5 EXT_shader_implicit_conversions "
             "EXT_shader_io_blocks EXT_shader_texture_samples EXT_tessellation_point_size "
             "EXT_tessellation_shader "
             "EXT_texture_buffer EXT_texture_cube_map_array EXT_texture_norm16 EXT_texture_query_lod "
             "NV_image_formats "
             "NV_viewport_array"))
        return "310 es";
    if (startsWith(name, "GL_ARB_geometry_shader4") || startsWith(name, "GL_EXT_geometry_shader4") ||
        isIn("EXT_gpu_shader4 EXT_texture_array ARB_shader_texture_lod ATI_shader_texture_lod "
             "ARB_draw_buffers "
             "ATI_draw_buffers ARB_draw_instanced EXT_texture_rectangle ARB_texture_rectangle "
             "ARB_shader_objects "
             "ARB_shading_language_100 ARB_vertex_shader ARB_fragment_shader ARB_compatibility "
             "EXT_texture_buffer_object"))
        return "120";
    return "150";
}

struct ShaderParts {
    std::set<std::string> declarations;
    std::string statements;
};

/// A shader of the stage that requires the extension and uses what `parts` has.
std::string extensionShader(const std::string& extension, const std::string& version, Stage stage,
                            const ShaderParts& parts) {
    std::string text = "#version " + (stage == Stage::compute ? std::string("420") : version) +
                       "\n#extension " + extension + " : require\n#ifndef " + extension +
                       "\n#error not defined\n#endif\n";
    const bool isOld = version == "100" || version == "120";
    switch (stage) {
        case Stage::geometry:
            if (!isOld) text += "layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n";
            break;
        case Stage::tessControl:
            text += "layout(vertices = 3) out;\n";
            break;
        case Stage::tessEvaluation:
            text += "layout(triangles, equal_spacing, cw, point_mode) in;\n";
            break;
        case Stage::compute:
            text += "layout(local_size_x = 8, local_size_y = 2, local_size_z = 1) in;\nshared vec4 all;\n";
            break;
        default:
            break;
    }
    for (const std::string& each : parts.declarations) text += each + "\n";
    const bool hasData = hasPart(parts.statements, "gl_FragData");
    std::string end = "gl_Position = r;";
    if (stage == Stage::fragment) {
        if (!isOld) text += "out vec4 fColor;\n";
        end = hasData ? "" : (isOld ? "gl_FragColor = r;" : "fColor = r;");
    }
    if (stage == Stage::tessControl) end = "gl_out[gl_InvocationID].gl_Position = r;";
    if (stage == Stage::compute) end = "all = r;";
    return text + "void main() {\n    vec4 r = vec4(1.);\n" + parts.statements + "    " + end + "\n}\n";
}

/// The stage with those that it cannot be without.
Stages withOtherStages(Stage stage, const std::string& version, const std::string& text) {
    const std::string head = "#version " + version + "\nvoid main() { ";
    Stages stages;
    if (stage == Stage::geometry || stage == Stage::tessControl || stage == Stage::tessEvaluation)
        stages.emplace_back(Stage::vertex, head + "gl_Position = vec4(1.); }\n");
    stages.emplace_back(stage, text);
    if (stage == Stage::tessControl)
        stages.emplace_back(Stage::tessEvaluation,
                            "#version 400\nlayout(triangles) in;\nvoid main() { "
                            "gl_Position = gl_in[0].gl_Position; }\n");
    return stages;
}

std::vector<std::string> addedWords(const Extension& extension) {
    std::vector<std::string> words;
    std::string_view rest = extension.adds;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        std::string word(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (word.front() != '+') words.push_back(word.substr(0, word.find('=')));
    }
    return words;
}

class Extensions : public testing::TestWithParam<Extension> {};

TEST_P(Extensions, EveryWordThatOneAddsWorks) {
    const std::string name(GetParam().name);
    const std::string version = dialectOf(name);
    std::map<Stage, ShaderParts> stages;
    if (GetParam().adds.empty()) stages[Stage::fragment];
    for (const std::string& word : addedWords(GetParam())) {
        const std::optional<WordUse> use = useOf(word);
        ASSERT_TRUE(use) << "no use of " << word << " is known";
        ShaderParts& parts = stages[use->stage];
        if (!use->declaration.empty()) parts.declarations.insert(use->declaration);
        if (!use->statement.empty()) parts.statements += "    " + use->statement + "\n";
    }
    for (const auto& [stage, parts] : stages) {
        const std::string text = extensionShader(name, version, stage, parts);
        ProgramRequest request = program(withOtherStages(stage, version, text));
        request.acceptsStorage = true;
        const TranslatedProgram translated = translate(request);
        for (const Diagnostic& each : translated.diagnostics) {
            // About the dialect, and about the other stages of the program.
            static const std::set<std::string> kExpected = {"glsl-W03", "glsl-W11", "glsl-W13", "glsl-W14",
                                                            "glsl-W19"};
            if (!kExpected.contains(each.id))
                ADD_FAILURE() << each.id << ": " << each.text << " at " << each.place.line << "\n" << text;
        }
        EXPECT_EQ("", glslangErrors(translated)) << text;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Extensions,
                         testing::ValuesIn(std::vector<Extension>(extensions().begin(), extensions().end())),
                         [](const auto& extension) { return std::string(extension.param.name); });

TEST(ExtensionTable, IsSortedAndHasEachNameOnce) {
    std::string before;
    for (const Extension& each : extensions()) {
        EXPECT_LT(before, each.name);
        before = each.name;
    }
}

}  // namespace
}  // namespace glibra::glsl::test
