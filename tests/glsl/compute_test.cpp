// Compute programs, and shaders of OpenGL 4.3 and later in every stage.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::string kSums = R"(#version 430 core
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer A { float a[]; };
layout(std430, binding = 1) writeonly buffer Sum { float sum[]; };
uniform float uScale = 2.;
void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= uint(a.length())) return;
    float total = 0.;
    for (int k = 0; k < 70000; k++) total += a[i];
    sum[i] = uScale * total;
}
)";

TEST(Compute, ProgramIsTranslated) {
    const TranslatedProgram translated = translateStages({{Stage::compute, kSums}});
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_TRUE(sourceOf(translated, Stage::compute).starts_with("#version 450 core\n"));
    EXPECT_EQ(0, translated.fragmentOutputs);
    ASSERT_EQ(1U, translated.uniforms.count("uScale"));
    EXPECT_TRUE(translated.uniforms.at("uScale").hasInitializer);
    EXPECT_EQ((Place{"a.comp", 5, 15}), translated.uniforms.at("uScale").place);
    ASSERT_EQ(1U, translated.stages.at(0).loops.size());
    EXPECT_EQ(70000, roundsOf(translated.stages[0].loops[0], {}));
    EXPECT_EQ((std::array{64, 1, 1}), translated.localSize);
}

TEST(Compute, VersionIsTheDrivers) {
    ProgramRequest request = program({{Stage::compute, kSums}});
    request.target.version = 430;
    EXPECT_TRUE(sourceOf(translate(request), Stage::compute).starts_with("#version 430 core\n"));
    EXPECT_EQ("", glslangErrors(translate(request)));
    request.target.version = 460;
    EXPECT_TRUE(sourceOf(translate(request), Stage::compute).starts_with("#version 460 core\n"));
}

TEST(Compute, PiecesSeeTheNumbersOfTheWhole) {
    ProgramRequest request = program({{Stage::compute, R"(#version 430 core
#define PLACE gl_GlobalInvocationID.x
layout(local_size_x = 8) in;
buffer Found { uint found[]; };
void main() { found[PLACE] = gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_LocalInvocationID.x; }
)"}});
    EXPECT_EQ(sourceOf(translate(request), Stage::compute).find("glibra_"), std::string::npos);
    EXPECT_FALSE(translate(request).inPieces);
    request.inPieces = true;
    const TranslatedProgram pieces = translate(request);
    EXPECT_EQ("", ids(pieces.diagnostics));
    EXPECT_EQ("", glslangErrors(pieces));
    EXPECT_TRUE(pieces.inPieces);
    const std::string source = sourceOf(pieces, Stage::compute);
    for (const char* name :
         {"uniform uvec3 glibra_FirstGroup;", "uniform uvec3 glibra_FirstInvocation;",
          "uniform uvec3 glibra_GroupCount;", "(gl_GlobalInvocationID + glibra_FirstInvocation).x"})
        EXPECT_NE(source.find(name), std::string::npos) << source;
}

TEST(Compute, OldDriverIsOneMessage) {
    ProgramRequest request = program({{Stage::compute, kSums}});
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("glsl-E12", ids(translated.diagnostics));
    EXPECT_EQ("compute shaders need OpenGL 4.3; this driver has 4.1",
              textOf(translated.diagnostics, "glsl-E12"));
    EXPECT_EQ(request.place, placeOf(translated.diagnostics, "glsl-E12"));
    EXPECT_TRUE(translated.stages.empty());
}

TEST(Compute, StandsAlone) {
    const TranslatedProgram translated =
        translateStages({{Stage::compute, kSums}, {Stage::fragment, kPlainFragment}});
    EXPECT_EQ("glsl-E13", ids(translated.diagnostics));
    EXPECT_TRUE(translated.stages.empty());
}

TEST(Compute, WithoutVersionIs430) {
    const TranslatedProgram translated = translateStages(
        {{Stage::compute,
          "layout(local_size_x = 8, local_size_y = 4) in;\nshared float part[__VERSION__];\nvoid main() { "
          "part[0] = 1.; barrier(); }\n"}});
    EXPECT_EQ("no #version, treated as 430 compatibility", textOf(translated.diagnostics, "glsl-W01"));
    EXPECT_EQ("glsl-W01", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::compute), "shared float part[430];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Compute, IncludesAndNamesWorkAsInOtherStages) {
    ProgramRequest request = program({{Stage::compute, R"(#version 430
#include "size.glsl"
layout(local_size_x = SIZE) in;
layout(rgba8) uniform writeonly image2D uOut;
layout(binding = 3) uniform sampler2D texture;
void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    vec3 p = vec3(at, Timer);
    vec4 c = texture(Noise3, p) + noise4(p) + texture2D(texture, p.xy) + uModelViewMatrix * gl_ProjectionMatrix[0];
    imageStore(uOut, at, c);
}
)"}});
    request.include = [](std::string_view name, std::string_view) -> std::optional<IncludedFile> {
        return IncludedFile{std::string(name), "#define SIZE 32\nconst int kHalf = 2;\n"};
    };
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("glsl-W05", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_EQ("texture", translated.userNames.at("glibra_texture"));
    EXPECT_EQ("gl_ProjectionMatrix", translated.userNames.at("glibra_ProjectionMatrix"));
    EXPECT_EQ(3, translated.textureBindings.at("texture"));
    EXPECT_EQ((std::array{32, 1, 1}), translated.localSize);
    EXPECT_EQ((std::vector<std::string>{"a.comp", "size.glsl"}), translated.stages.at(0).lineMap.files);
}

TEST(Compute, HasNoVertexInputs) {
    const TranslatedProgram translated = translateStages(
        {{Stage::compute,
          "#version 430\nlayout(local_size_x = 1) in;\nvoid main() { vec4 p = gl_Vertex; }"}});
    EXPECT_EQ("gl_Vertex is a vertex input, and a compute stage has none; read a buffer",
              textOf(translated.diagnostics, "glsl-E03"));
}

TEST(Compute, NamesOfTheStageElsewhere) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment, "#version 430\nvoid main() { uint i = gl_GlobalInvocationID.x; }");
    EXPECT_EQ("gl_GlobalInvocationID only exists in a compute stage; name this file with 'Compute'",
              textOf(translated.diagnostics, "glsl-E03"));
}

const std::string kStorage = R"(
struct Particle { vec4 position; vec3 velocity; float age; };
layout(std430, binding = 2) buffer Particles { Particle particles[]; };
layout(std430) readonly buffer Rest { uint count; mat3 frames[4]; } rest;
layout(std140, binding = 1) uniform Light { vec4 ambient; vec3 position; } light;
layout(rgba32f, binding = 5) uniform readonly image2D uPicture;
layout(r32ui) coherent uniform volatile restrict uimage2DArray uCounts[2];
layout(binding = 0, offset = 4) uniform atomic_uint uAtomic;
subroutine vec4 Shade(vec4 base);
layout(index = 1) subroutine(Shade) vec4 plain(vec4 base) { return base; }
layout(index = 0) subroutine(Shade) vec4 half_(vec4 base) { return .5 * base; }
layout(location = 0) subroutine uniform Shade uShade;
vec4 work(int i)
{
    memoryBarrier();
    particles[i].age += 1.;
    uint n = atomicCounterIncrement(uAtomic) + atomicAdd(rest_count, 1u);
    imageAtomicAdd(uCounts[1], ivec3(0), n);
    return uShade(imageLoad(uPicture, ivec2(0)) + light.ambient + vec4(rest.frames[1] * particles[i].velocity, 1.));
}
layout(std430) buffer Other { uint rest_count; uint data[][2]; };
)";

TEST(ModernShaders, PassThroughEveryStage) {
    const auto text = [](const std::string& head, const std::string& main) {
        std::string storage = kStorage;
        const std::string other = "layout(std430) buffer Other { uint rest_count; uint data[][2]; };\n";
        storage.erase(storage.find(other), other.size());
        return "#version 430 core\n" + head + other + storage + main;
    };
    const Stages all = {
        {Stage::vertex, text("layout(location = 0) in vec4 aPosition;\n",
                             "void main() { gl_Position = aPosition + work(gl_VertexID); }\n")},
        {Stage::tessControl,
         text("layout(vertices = 3) out;\n",
              "void main() { gl_out[gl_InvocationID].gl_Position = work(gl_InvocationID); "
              "gl_TessLevelInner[0] "
              "= gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = 1.; }\n")},
        {Stage::tessEvaluation,
         text("layout(triangles) in;\n", "void main() { gl_Position = work(gl_PrimitiveID); }\n")},
        {Stage::geometry, text("layout(triangles) in;\nlayout(points, max_vertices = 1) out;\n",
                               "void main() { gl_Position = work(gl_PrimitiveIDIn); EmitVertex(); }\n")},
        {Stage::fragment, text("layout(location = 0) out vec4 fColor;\nlayout(early_fragment_tests) in;\n",
                               "void main() { fColor = work(int(gl_FragCoord.x)); }\n")}};
    ProgramRequest request = program(all);
    request.acceptsStorage = true;
    for (const int version : {430, 450, 460}) {
        request.target.version = version;
        const TranslatedProgram translated = translate(request);
        EXPECT_EQ("", ids(translated.diagnostics));
        EXPECT_EQ("", glslangErrors(translated)) << version;
        for (const TranslatedStage& each : translated.stages) EXPECT_TRUE(each.facts.writesMemory);
    }
    const TranslatedProgram compute = translateStages(
        {{Stage::compute,
          text("layout(local_size_x = 16, local_size_y = 16, local_size_z = 2) in;\n",
               "void main() { data[0][1] = uint(work(int(gl_LocalInvocationIndex)).x); }\n")}});
    EXPECT_EQ("", ids(compute.diagnostics));
    EXPECT_EQ("", glslangErrors(compute));
    EXPECT_EQ((std::array{16, 16, 2}), compute.localSize);
}

TEST(ModernShaders, StorageNeedsAScene) {
    const std::string text =
        "#version 430\nbuffer B { float b; };\nlayout(binding = 0) uniform atomic_uint n;\nout vec4 o;\n"
        "void main() { o = vec4(b); }";
    EXPECT_EQ("glsl-E09 glsl-E09", ids(translateSingle(Stage::fragment, text).diagnostics));
    ProgramRequest request = single(Stage::fragment, text);
    request.acceptsStorage = true;
    EXPECT_EQ("", ids(translate(request).diagnostics));
    request.target.version = 410;
    const TranslatedProgram old = translate(request);
    EXPECT_EQ("glsl-E03 glsl-E03", ids(old.diagnostics));
    EXPECT_EQ("buffer block 'B' needs GLSL 4.30, this driver has 4.10", textOf(old.diagnostics, "glsl-E03"));
    request.target.hasExtension = [](std::string_view name) {
        return name == "GL_ARB_shader_storage_buffer_object" || name == "GL_ARB_shader_atomic_counters";
    };
    EXPECT_EQ("", ids(translate(request).diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translate(request), Stage::fragment),
                          "layout(binding = 0) uniform atomic_uint n;"));
}

}  // namespace
}  // namespace glibra::glsl::test
