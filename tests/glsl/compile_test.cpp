// Programs in every dialect are translated, and an independent compiler checks them: glslangValidator
// compiles and links all stages, at the usual target and at the lowest.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

struct Sample {
    const char* name;
    Stages stages;
};

const std::string kVert110 = R"(
attribute float aWeight;
varying vec3 vNormal; varying float vLight;
uniform vec3 uLight; uniform bool uOn;
const float kScale = 1.5;
float shade(vec3 n, vec3 l) { return max(dot(n, l), 0.0) * kScale; }
void main()
{
    vec3 ec = vec3(gl_ModelViewMatrix * gl_Vertex);
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vLight = uOn ? shade(vNormal, normalize(uLight - ec)) : aWeight;
    gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
}
)";
const std::string kFrag110 = R"(
varying vec3 vNormal; varying float vLight;
uniform sampler2D uPicture; uniform sampler3D Noise3; uniform float uMix;
void main()
{
    vec4 t = texture2D(uPicture, gl_TexCoord[0].st);
    vec4 n = texture3D(Noise3, vNormal * .5 + .5);
    float f = n.r + n.g + n.b + n.a - 2.;
    if (f < -1.) discard;
    gl_FragColor = vec4(mix(t.rgb, gl_Color.rgb, uMix) * vLight * (1. + f), 1.);
}
)";
const std::string kFrag120 = R"(
varying vec3 vNormal;
varying float vLight;
uniform sampler2DShadow uShadow;
mat3 basis = mat3(1., 0., 0., 0., 1., 0., 0., 0., 1.);
const vec2 taps[4] = vec2[4](vec2(0.), vec2(1., 0.), vec2(0., 1.), vec2(1.));
void main()
{
    float sum = 0.;
    for (int i = 0; i < taps.length(); i++) sum += shadow2D(uShadow, vec3(taps[i], .5)).r;
    vec3 c = pow(abs(basis * vNormal), 2.);
    gl_FragData[0] = vec4(c * sum * vLight, 1);
    gl_FragData[1] = gl_FrontMaterial.diffuse * gl_LightSource[0].diffuse + gl_Fog.color;
}
)";
const std::string kGeomOld = R"(
#extension GL_EXT_geometry_shader4: enable
#extension GL_EXT_gpu_shader4: enable
uniform float uShrink;
varying in vec3 vNormal[gl_VerticesIn];
varying out vec3 gNormal;
varying float gLight;
vec3 centre;
void produce(int i)
{
    gNormal = normalize(vNormal[i]);
    gLight = abs(gNormal.z);
    gl_TexCoord[0] = gl_TexCoordIn[i][0];
    gl_FrontColor = gl_FrontColorIn[i];
    gl_Position = gl_ProjectionMatrix * vec4(centre + uShrink * (gl_PositionIn[i].xyz - centre), 1.);
    EmitVertex();
}
void main()
{
    centre = (gl_PositionIn[0].xyz + gl_PositionIn[1].xyz + gl_PositionIn[2].xyz) / 3.;
    for (int i = 0; i < gl_VerticesIn; i++) produce(i);
    EndPrimitive();
}
)";
const std::string kFragGeom = R"(
varying vec3 gNormal; varying float gLight;
void main() { gl_FragColor = vec4(gNormal * gLight, 1.) + gl_Color + gl_TexCoord[0]; }
)";

std::vector<Sample> samples() {
    std::vector<Sample> all;
    all.push_back(
        {"GLSL 1.10",
         {{Stage::vertex, "#version 110" + kVert110}, {Stage::fragment, "#version 110" + kFrag110}}});
    all.push_back(
        {"GLSL 1.20",
         {{Stage::vertex, "#version 120" + kVert110}, {Stage::fragment, "#version 120" + kFrag120}}});
    all.push_back({"no version", {{Stage::vertex, kVert110}, {Stage::fragment, kFrag110}}});
    all.push_back({"EXT_geometry_shader4",
                   {{Stage::vertex, "#version 120" + kVert110},
                    {Stage::geometry, "#version 120" + kGeomOld},
                    {Stage::fragment, "#version 120" + kFragGeom}}});
    all.push_back({"EXT_geometry_shader4 on 1.50",
                   {{Stage::vertex, "#version 150 compatibility" + kVert110},
                    {Stage::geometry, "#version 150 compatibility" + kGeomOld},
                    {Stage::fragment, "#version 150 compatibility" + kFragGeom}}});
    all.push_back({"GLSL 1.30",
                   {{Stage::vertex, R"(#version 130
in vec3 aOwn;
out vec3 vP; flat out int vFace; centroid out vec2 vST; noperspective out float vD;
uniform mat4 uModelViewProjectionMatrix;
void main() { vP = aOwn + gl_Normal; vFace = gl_VertexID & 3; vST = gl_MultiTexCoord0.st; vD = vP.z; gl_Position = uModelViewProjectionMatrix * vec4(aOwn, 1); }
)"},
                    {Stage::fragment, R"(#version 130
in vec3 vP; flat in int vFace; in centroid vec2 vST; noperspective in float vD;
uniform isampler2D uI; uniform samplerCube uCube; uniform int uMode;
out vec4 fColor;
void main() {
    uint h = uint(vFace) * 7u % 3u;
    switch (uMode) { case 0: fColor = texture(uCube, vP); break; default: fColor = textureLod(uCube, vP, 1.); }
    ivec4 i = texelFetch(uI, ivec2(vST * 8.), 0) >> 1;
    fColor += vec4(i) + float(h) + vD + fwidth(vST.x);
}
)"}}});
    all.push_back({"3.30 compatibility",
                   {{Stage::vertex, R"(#version 330 compatibility
layout(location = 0) in vec4 aVertex;
out vec2 vST; out vec4 vColor; out float vLightIntensity;
out Surface { vec3 normal; vec3 eye; } surface;
void main() {
    vST = gl_MultiTexCoord0.st; vColor = gl_Color;
    surface.normal = normalize(uNormalMatrix * aNormal);
    surface.eye = vec3(uModelViewMatrix * aVertex);
    vLightIntensity = dot(surface.normal, normalize(vec3(0., 0., 10.) - surface.eye));
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
)"},
                    {Stage::fragment, R"(#version 330 compatibility
in vec2 vST; in vec4 vColor; in float vLightIntensity;
in Surface { vec3 normal; vec3 eye; } surface;
uniform float uAd = .1, uTol = 0.01; uniform vec4 uColor;
layout(std140) uniform Extra { vec4 tint; float weights[4]; };
uniform sampler2D uTexture;
void main() {
    float Ar = uAd / 2;
    const float d = vST.s * 2.;
    vec3 rgb = mix(uColor.rgb, vec3(1, .5, 0), smoothstep(1. - uTol, 1. + uTol, d));
    rgb = texture2D(uTexture, vST).rgb * rgb * tint.rgb * weights[int(vST.t * 3.)];
    gl_FragColor = vec4(rgb * vLightIntensity, vColor.a) + reflect(surface.eye, surface.normal).xyzz * Ar;
}
)"}}});
    all.push_back({"4.00 tessellation",
                   {{Stage::vertex,
                     "#version 400 compatibility\nout vec3 vN;\nvoid main() { vN = gl_Normal; gl_Position = "
                     "gl_Vertex; }\n"},
                    {Stage::tessControl, R"(#version 400 compatibility
#extension GL_ARB_tessellation_shader : enable
uniform float uOuter02, uInner;
layout( vertices = 3 ) out;
in vec3 vN[]; out vec3 tcN[]; patch out float tcRadius;
void main( ) {
    gl_out[ gl_InvocationID ].gl_Position = gl_in[ gl_InvocationID ].gl_Position;
    tcN[gl_InvocationID] = vN[gl_InvocationID];
    barrier();
    tcRadius = length(gl_in[0].gl_Position.xyz);
    gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = uOuter02;
    gl_TessLevelInner[0] = uInner;
}
)"},
                    {Stage::tessEvaluation, R"(#version 400 compatibility
#extension GL_ARB_tessellation_shader : enable
layout( triangles, equal_spacing, ccw) in;
in vec3 tcN[]; patch in float tcRadius; out vec3 teN;
void main() {
    vec4 p = gl_TessCoord.x * gl_in[0].gl_Position + gl_TessCoord.y * gl_in[1].gl_Position + gl_TessCoord.z * gl_in[2].gl_Position;
    teN = tcN[0] * gl_TessCoord.x + tcN[1] * gl_TessCoord.y + tcN[2] * gl_TessCoord.z;
    gl_Position = gl_ModelViewMatrix * vec4(tcRadius * normalize(p.xyz), 1.);
}
)"},
                    {Stage::geometry, R"(#version 400 compatibility
#extension GL_EXT_gpu_shader4: enable
#extension GL_EXT_geometry_shader4: enable
layout( triangles ) in;
layout( triangle_strip, max_vertices=32 ) out;
in vec3 teN[3];
out float gLightIntensity;
void main() {
    for (int i = 0; i < 3; i++) { gLightIntensity = abs(normalize(gl_NormalMatrix * teN[i]).z); gl_Position = gl_ProjectionMatrix * gl_PositionIn[i]; EmitVertex(); }
    EndPrimitive();
}
)"},
                    {Stage::fragment,
                     "#version 400 compatibility\nin float gLightIntensity;\nuniform vec4 uColor;\nvoid "
                     "main() { gl_FragColor = vec4(gLightIntensity * uColor.rgb, 1.); }\n"}}});
    all.push_back({"4.30",
                   {{Stage::vertex, R"(#version 430
layout(location = 5) uniform mat4 uModelViewProjectionMatrix;
layout(location = 0) in vec3 aVertex; in layout(location = 2) vec3 aNormal;
layout(location = 1) out vec3 vN;
vec3 table[2] = { { 1., 0., 0. }, { 0., 1., 0. } };
float half1() { return 1; }
void main() { const vec3 n = aNormal * half1(); vN = n + table[gl_VertexID & 1]; gl_Position = uModelViewProjectionMatrix * vec4(aVertex, 1.); }
)"},
                    {Stage::fragment, R"(#version 430
layout(binding = 3) uniform sampler2D uA; layout(std140, binding = 1) uniform B { vec4 b; };
in layout(location = 1) vec3 vOther;
out layout(location = 0) vec4 fA; layout(location = 1) out vec4 fB;
void main() { float w[] = { .1, .2, .7, }; fA = texture(uA, vOther.xy) * b; fB = vec4(fma(w[0], w[1], w[2])); }
)"}}});
    return all;
}

class Compile : public testing::TestWithParam<int> {};

TEST_P(Compile, EveryDialectAtThisTarget) {
    for (const Sample& sample : samples()) {
        ProgramRequest request = program(sample.stages);
        request.target.version = GetParam();
        const TranslatedProgram translated = translate(request);
        EXPECT_FALSE(hasError(translated.diagnostics)) << sample.name << ": " << ids(translated.diagnostics);
        EXPECT_EQ("", glslangErrors(translated)) << sample.name;
    }
}

TEST_P(Compile, SeveralTargetsAndFlatColors) {
    for (const Sample& sample : samples()) {
        ProgramRequest request = program(sample.stages);
        request.target.version = GetParam();
        request.colorTargets = 4;
        request.flatColors = true;
        EXPECT_EQ("", glslangErrors(translate(request))) << sample.name;
    }
}

TEST_P(Compile, TranslationIsAFunction) {
    for (const Sample& sample : samples()) {
        ProgramRequest request = program(sample.stages);
        request.target.version = GetParam();
        const TranslatedProgram once = translate(request), again = translate(request);
        for (std::size_t i = 0; i < once.stages.size(); ++i)
            EXPECT_EQ(once.stages[i].source, again.stages[i].source);
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, Compile, testing::Values(410, 430, 450),
                         [](const auto& target) { return std::to_string(target.param); });

TEST(Target410, QualifiersAreReordered) {
    ProgramRequest request =
        single(Stage::vertex,
               "#version 430\nout flat vec3 a; in layout(location = 2) highp vec4 b; out centroid smooth "
               "vec2 c;\nvoid main() { a = b.xyz; c = b.xy; gl_Position = b; }");
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::vertex),
                  "flat out vec3 a; layout(location = 2) in highp vec4 b; smooth centroid out vec2 c;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Target410, BindingsAreTakenOutAndReported) {
    ProgramRequest request =
        single(Stage::fragment,
               "#version 430\nlayout(binding = 4) uniform sampler2D s; layout(location = 1) uniform float f; "
               "layout(std140, binding = 2) uniform B { vec4 b; }; layout(binding = 1, std140) uniform C { "
               "vec4 c; };\nout vec4 o; void main() { o = texture(s, vec2(f)) * b * c; }");
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ(4, translated.textureBindings.at("s"));
    EXPECT_EQ(std::string::npos, sourceOf(translated, Stage::fragment).find("binding"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Target410, BracesBecomeConstructors) {
    ProgramRequest request = single(
        Stage::fragment,
        "const float w[3] = { 1., 2., 3. };\nout vec4 o; void main() { vec2 p[2] = { { 0., 1. }, { 2., 3. } "
        "}; vec3 v = { 1., 2., 3. }; float[2] q = { 1., 2., }; o = vec4(w[2], p[1], v.x + q[0]); }");
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::fragment), "vec2 p[2] = vec2[](vec2(0., 1.), vec2(2., 3.));"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Target410, LocalConstantsNeedNotBeConstant) {
    ProgramRequest request =
        single(Stage::fragment,
               "uniform float u; const float k = 2.;\nout vec4 o; void f(float p) { const float a = p; const "
               "float b = a * 2.; const int n = 3; float x[n]; x[0] = b; o = vec4(x[0]); }\nvoid main() { "
               "const vec2 c = vec2(u); const float d = sqrt(k); f(c.x + d); }");
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "const int n = 3;"));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "const float d = sqrt(k);"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Target410, ReturnValuesAreConverted) {
    ProgramRequest request = single(
        Stage::fragment,
        "float f(int i) { if (i > 1) return i * 2; return 0; }\nout vec4 o; void main() { o = vec4(f(2)); }");
    request.target.version = 410;
    EXPECT_TRUE(
        hasTokens(userPart(translate(request), Stage::fragment), "return float(i * 2); return float(0);"));
    EXPECT_EQ("", glslangErrors(translate(request)));
}

TEST(Target410, ScalarSwizzlesBecomeConstructors) {
    ProgramRequest request =
        single(Stage::fragment,
               "uniform float u; out vec4 o;\nfloat f() { return 1.; }\nvoid main() { float a = u.x; a.x = "
               "2.; o = vec4(u.xxx + f().rrr, (a + 1.).x) * a.xxxx; }");
    request.target.version = 410;
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment),
                          "float a = u; a = 2.; o = vec4(vec3(u) + vec3(f()), (a + 1.)) * vec4(a);"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Target410, LocationsOfBlocksGiveWayToTheirNames) {
    ProgramRequest request =
        program({{Stage::vertex,
                  "#version 440\nlayout(location = 1) out Data { vec3 n; layout(location = 3) vec2 t; } d; "
                  "void main() { d.n = vec3(1.); d.t = vec2(1.); gl_Position = aVertex; }\n"},
                 {Stage::fragment,
                  "#version 440\nlayout(location = 1) in Data { vec3 n; layout(location = 3) vec2 t; } d; "
                  "layout(depth_less) out float gl_FragDepth; out vec4 o; void main() { o = vec4(d.n, "
                  "d.t.x); gl_FragDepth = 0.; }\n"}});
    request.target.version = 410;
    EXPECT_EQ("", glslangErrors(translate(request)));
}

TEST(Target410, WhatItLacksIsRefusedByVersion) {
    for (const auto& [text, version] :
         {std::pair{"float a[2][3];", "4.30"}, std::pair{"layout(early_fragment_tests) in;", "4.20"},
          std::pair{"layout(location = 0, component = 1) in float c;", "4.40"},
          std::pair{"void f() { memoryBarrier(); }", "4.20"},
          std::pair{"int f() { return gl_Layer; }", "4.30"},
          std::pair{"float f(vec2 s) { return dFdxFine(s.x); }", "4.50"}}) {
        ProgramRequest request = single(Stage::fragment, std::string("#version 450\n") + text +
                                                             "\nout vec4 o; void main() { o = vec4(1.); }");
        EXPECT_FALSE(has(translate(request).diagnostics, "glsl-E03")) << text;
        request.target.version = 410;
        EXPECT_NE(std::string::npos, test::textOf(translate(request).diagnostics, "glsl-E03")
                                         .find(std::string("needs GLSL ") + version))
            << text;
    }
}

TEST(Target410, InterpolationIsTheReaders) {
    ProgramRequest request = program(
        {{Stage::vertex, "#version 330\nout int v; void main() { v = 1; gl_Position = aVertex; }\n"},
         {Stage::fragment, "#version 330\nflat in int v; out vec4 o; void main() { o = vec4(v); }\n"}});
    request.target.version = 410;
    EXPECT_TRUE(hasTokens(userPart(translate(request), Stage::vertex), "flat out int v;"));
}

}  // namespace
}  // namespace glibra::glsl::test
