// Texture functions of older versions, ftransform and the noise functions (language, 7.5).

#include <gtest/gtest.h>

#include "glsl/rules/rules.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

TEST(TextureFunctions, DimensionAndVendorAreDropped) {
    const std::pair<const char*, const char*> cases[] = {{"texture1D", "texture"},
                                                         {"texture2D", "texture"},
                                                         {"texture3D", "texture"},
                                                         {"textureCube", "texture"},
                                                         {"texture2DRect", "texture"},
                                                         {"texture1DArray", "texture"},
                                                         {"texture2DArray", "texture"},
                                                         {"texture1DProj", "textureProj"},
                                                         {"texture2DProj", "textureProj"},
                                                         {"texture3DProj", "textureProj"},
                                                         {"texture2DRectProj", "textureProj"},
                                                         {"texture1DLod", "textureLod"},
                                                         {"texture2DLod", "textureLod"},
                                                         {"textureCubeLod", "textureLod"},
                                                         {"texture2DArrayLod", "textureLod"},
                                                         {"texture2DLodEXT", "textureLod"},
                                                         {"texture2DProjLod", "textureProjLod"},
                                                         {"texture2DProjLodEXT", "textureProjLod"},
                                                         {"texture2DGrad", "textureGrad"},
                                                         {"texture2DGradARB", "textureGrad"},
                                                         {"textureCubeGradEXT", "textureGrad"},
                                                         {"texture2DProjGradARB", "textureProjGrad"},
                                                         {"texture2DOffset", "textureOffset"},
                                                         {"texture2DProjOffset", "textureProjOffset"},
                                                         {"texture2DLodOffset", "textureLodOffset"},
                                                         {"texture2DProjLodOffset", "textureProjLodOffset"},
                                                         {"texture2DGradOffset", "textureGradOffset"},
                                                         {"texture2DProjGradOffset", "textureProjGradOffset"},
                                                         {"texelFetch1D", "texelFetch"},
                                                         {"texelFetch2D", "texelFetch"},
                                                         {"texelFetch2DRect", "texelFetch"},
                                                         {"texelFetchBuffer", "texelFetch"},
                                                         {"texelFetch2DArray", "texelFetch"},
                                                         {"texelFetch2DOffset", "texelFetchOffset"},
                                                         {"textureSize2D", "textureSize"},
                                                         {"textureSizeCube", "textureSize"},
                                                         {"textureQueryLOD", "textureQueryLod"}};
    for (const auto& [old, core] : cases) EXPECT_EQ(core, textureFunction(old).core) << old;
}

TEST(TextureFunctions, OtherNamesAreNotTouched) {
    for (const char* name : {"texture", "textureLod", "textures2D", "texture2DBlend", "shadow", "shadowMap",
                             "texture4D", "textureBlur"})
        EXPECT_EQ("", textureFunction(name).core) << name;
}

TEST(TextureFunctions, NamesSayTheSampler) {
    EXPECT_EQ("sampler2D", textureFunction("texture2DProjLod").sampler);
    EXPECT_EQ("samplerCube", textureFunction("textureCube").sampler);
    EXPECT_EQ("sampler2DShadow", textureFunction("shadow2D").sampler);
}

TEST(TextureFunctions, ShadowFunctionsReturnFourComponents) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 110\nuniform sampler2DShadow s; uniform sampler1DShadow t;\nvoid main() { gl_FragColor = "
        "shadow2D(s, vec3(.5)) + vec4(shadow2DProj(s, vec4(1.)).r) + shadow1D(t, vec3(1.)); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "vec4(texture(s, vec3(.5)))"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TextureFunctions, AllOldFormsCompile) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 120\n#extension GL_EXT_gpu_shader4 : enable\n"
        "uniform sampler1D s1; uniform sampler2D s2; uniform sampler3D s3; uniform samplerCube sc; uniform "
        "sampler2DRect sr; uniform sampler2DArray sa; uniform samplerBuffer sb;\n"
        "void main() {\n"
        " vec4 c = texture1D(s1, .5) + texture1D(s1, .5, 1.) + texture2D(s2, vec2(0.), .5) + texture3D(s3, "
        "vec3(0.)) + textureCube(sc, vec3(1.));\n"
        " c += texture1DProj(s1, vec2(1.)) + texture2DProj(s2, vec3(1.)) + texture2DProj(s2, vec4(1.)) + "
        "texture3DProj(s3, vec4(1.)) + texture2DRect(sr, vec2(1.)) + texture2DRectProj(sr, vec3(1.));\n"
        " c += texture2DLod(s2, vec2(0.), 1.) + texture2DProjLod(s2, vec3(1.), 1.) + textureCubeLod(sc, "
        "vec3(1.), 0.) + texture2DArray(sa, vec3(0.)) + texture2DArrayLod(sa, vec3(0.), 0.);\n"
        " c += texture2DGradARB(s2, vec2(0.), vec2(0.), vec2(0.)) + texture2DOffset(s2, vec2(0.), ivec2(1)) "
        "+ texelFetch2D(s2, ivec2(0), 0) + texelFetchBuffer(sb, 1) + texelFetch2DRect(sr, ivec2(0));\n"
        " ivec2 size = textureSize2D(s2, 0) + textureSize2DRect(sr, 0) + texelSize(s2, 0);\n"
        " gl_FragColor = c * float(size.x) * truncate(1.5);\n}\n");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TextureFunctions, MacroBodiesAreTranslated) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 120\nuniform sampler2D s; uniform sampler2DShadow d;\n#define TEX texture2D\n#define "
        "FETCH(u) texture2DLod(s, u, 0.)\n#define SHADE(p) shadow2D(d, p).r\nvoid main() { gl_FragColor = "
        "TEX(s, vec2(.5)) + FETCH(vec2(1.)) * SHADE(vec3(1.)); }");
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(TextureFunctions, UsersMacroOfThatNameCounts) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 330\n#define texture2D texture\nuniform sampler2D s; out vec4 o;\nvoid "
                        "main() { o = texture2D(s, vec2(.5)); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "o = texture(s, vec2(.5));"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Functions, TexelSizeIsAnOrdinaryNameForVariables) {
    EXPECT_TRUE(hasTokens(
        userFragment("out vec4 o; uniform vec2 texelSize; void main() { o = vec4(texelSize, (texelSize)); }"),
        "vec4(texelSize, (texelSize))"));
}

TEST(Functions, FtransformIsTheProductAndInvariant) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex, "#version 110\nvoid main() { gl_Position = ftransform ( ); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::vertex),
                          "gl_Position = (glibra_ModelViewProjectionMatrix * glibra_Vertex) ;"));
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::vertex), "invariant gl_Position;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Functions, UnsignedIntIsUint) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\n#extension GL_EXT_gpu_shader4 : enable\nvoid main() { unsigned int a "
                        "= 3u; gl_FragColor = vec4(float(a)); }");
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(NoiseFunctions, AreEmittedOnlyWhenUsed) {
    const std::string with =
        sourceOf(translateSingle(
                     Stage::fragment,
                     "#version 120\nvoid main() { gl_FragColor = vec4(noise1(.5), noise2(vec3(1.)), 1.); }"),
                 Stage::fragment);
    EXPECT_TRUE(hasTokens(with, "float glibra_noise1(vec4 p)"));
    EXPECT_TRUE(hasTokens(with, "vec2 glibra_noise2(vec3 p)"));
    EXPECT_FALSE(hasTokens(with, "vec3 glibra_noise3("));
    const std::string without =
        sourceOf(translateSingle(Stage::fragment, "#version 120\nvoid main() { gl_FragColor = vec4(1.); }"),
                 Stage::fragment);
    EXPECT_EQ(std::string::npos, without.find("noise"));
}

TEST(NoiseFunctions, EveryFormCompiles) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nvarying vec4 v;\nvoid main() { vec4 c = vec4(0.);\n"
                        " c.x += noise1(v.x) + noise1(v.xy) + noise1(v.xyz) + noise1(v) + noise1(1);\n c.xy "
                        "+= noise2(v.x) + noise2(v.xy) + noise2(v.xyz) + noise2(v);\n"
                        " c.xyz += noise3(v.x) + noise3(v.xy) + noise3(v.xyz) + noise3(v);\n c += "
                        "noise4(v.x) + noise4(v.xy) + noise4(v.xyz) + noise4(v);\n gl_FragColor = c; }");
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(OwnOverloads, StandBesideTheBuiltInFunctionsInEs100) {
    const std::string head =
        "#version 100\nprecision mediump float;\nvarying vec2 vST;\nuniform sampler2D uTex;\n";
    const std::string texts[] = {
        "vec2 max(float a, vec2 b) { return b * a; }\n"
        "void main() { gl_FragColor = vec4(max(.5, vST), max(vST, vec2(.5))); }\n",
        "vec4 texture2D(sampler2D s, float x, float y) { return texture2D(s, vec2(x, y)); }\n"
        "void main() { gl_FragColor = texture2D(uTex, .25, .25) + texture2D(uTex, vST); }\n",
        "float clamp(float x);\nfloat clamp(float x) { return clamp(x, 0., 1.); }\n"
        "void main() { gl_FragColor = vec4(clamp(vST.s * 2.)); }\n",
        "float length(float a, float b) { return a + b; }\nfloat mix(float a, bool b) { return b ? a : 0.; "
        "}\n"
        "void main() { gl_FragColor = vec4(length(1., 2.) + length(vec2(3., 4.)), mix(.5, true), mix(0., 1., "
        "vST.s), "
        "1.); }\n"};
    for (const std::string& text : texts) {
        const TranslatedProgram translated = translateSingle(Stage::fragment, head + text);
        EXPECT_EQ("glsl-W03", ids(translated.diagnostics)) << text;
        EXPECT_EQ("", glslangErrors(translated)) << text;
    }
    const std::string emitted = userFragment(head + texts[0]);
    EXPECT_TRUE(hasTokens(emitted, "glibra_own_max(.5, vST), max(vST, vec2(.5))")) << emitted;
}

TEST(OwnOverloads, HideTheBuiltInFunctionsInOtherVersions) {
    EXPECT_FALSE(
        hasTokens(userFragment("#version 330\nout vec4 c;\nvec2 max(float a, vec2 b) { return b * a; }\n"
                               "void main() { c = vec4(max(.5, vec2(1.)), 0., 1.); }\n"),
                  "glibra_own_max"));
}

TEST(Pragmas, InvariantAllIsLeftOutOfFragmentStagesOfEs100) {
    const std::string text =
        "#pragma STDGL invariant(all)\nprecision mediump float;\nvoid main() { gl_FragColor = "
        "vec4(1.); }\n";
    EXPECT_FALSE(hasTokens(userFragment("#version 100\n" + text), "STDGL"));
    EXPECT_TRUE(hasTokens(sourceOf(translateSingle(Stage::vertex,
                                                   "#version 100\n#pragma STDGL invariant(all)\nvoid "
                                                   "main() { gl_Position = vec4(0.); }\n"),
                                   Stage::vertex),
                          "STDGL"));
}

}  // namespace
}  // namespace glibra::glsl::test
