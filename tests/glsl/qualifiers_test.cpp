// Storage qualifiers of older versions, and reserved words as names (language, 7.4).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

std::string vertex(const std::string& text) {
    return userPart(translateSingle(Stage::vertex, text), Stage::vertex);
}

TEST(Qualifiers, AttributeBecomesIn) {
    EXPECT_TRUE(hasTokens(vertex("#version 110\nattribute vec3 a, b;"), "in vec3 a, b;"));
}

TEST(Qualifiers, VaryingDependsOnTheStage) {
    EXPECT_TRUE(hasTokens(vertex("#version 110\nvarying vec3 v;"), "out vec3 v;"));
    EXPECT_TRUE(hasTokens(userFragment("#version 110\nvarying vec3 v;"), "in vec3 v;") ||
                hasTokens(userFragment("#version 110\nvarying vec3 v;"), "vec3 v"));
}

TEST(Qualifiers, InterpolationStaysWithVarying) {
    EXPECT_TRUE(hasTokens(vertex("#version 120\ncentroid varying vec3 v;"), "centroid out vec3 v;"));
    EXPECT_TRUE(hasTokens(vertex("#version 130\nflat varying vec3 v;"), "flat out vec3 v;"));
    EXPECT_TRUE(
        hasTokens(vertex("#version 130\nnoperspective varying vec3 v;"), "noperspective out vec3 v;"));
    EXPECT_TRUE(hasTokens(vertex("#version 120\ninvariant varying vec3 v;"), "invariant out vec3 v;"));
}

TEST(Qualifiers, GeometryVaryingsFollowTheirWords) {
    const std::string text =
        userPart(translateSingle(
                     Stage::geometry,
                     "#version 120\n#extension GL_EXT_geometry_shader4 : enable\n"
                     "varying in vec3 a[gl_VerticesIn]; in varying vec3 b[]; varying vec3 c[gl_VerticesIn];\n"
                     "varying out vec3 d; out varying vec3 e; varying vec3 f;\n"
                     "void main() { d = e = f = a[0] + b[0] + c[0]; EmitVertex(); }"),
                 Stage::geometry);
    EXPECT_TRUE(hasTokens(text, "in vec3 a[];"));
    EXPECT_TRUE(hasTokens(text, "in vec3 b[];"));
    EXPECT_TRUE(hasTokens(text, "in vec3 c[];"));
    EXPECT_TRUE(hasTokens(text, "out vec3 d;"));
    EXPECT_TRUE(hasTokens(text, "out vec3 e;"));
    EXPECT_TRUE(hasTokens(text, "out vec3 f;"));
}

TEST(Qualifiers, MacroForAStorageWordIsExpanded) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "#version 120\n#define VARYING varying\nVARYING vec3 v;\nvoid main() { v = vec3(0.); "
                        "gl_Position = vec4(0.); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::vertex), "out vec3 v;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Qualifiers, MacroForAWholeHeadIsExpanded) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "#version 120\n#define ATTRIBUTE attribute highp vec3\nATTRIBUTE v;\nvoid main() { "
                        "gl_Position = vec4(v, 1.); }");
    EXPECT_TRUE(translated.vertexInputs.contains("v"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Reserved, WordFreeInTheVersionIsRenamed) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nuniform float sample, patch;\nvoid main() { float uint = sample + "
                        "patch; gl_FragColor = vec4(uint); }");
    EXPECT_EQ("'patch' is a reserved word, renamed", textOf(translated.diagnostics, "glsl-W05"));
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::fragment), "uniform float glibra_sample, glibra_patch;"));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment),
                          "float glibra_uint = glibra_sample + glibra_patch;"));
    EXPECT_EQ("sample", translated.userNames.at("glibra_sample"));
    EXPECT_TRUE(translated.uniforms.contains("sample"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Reserved, EveryWordOfTheListWorksAsAName) {
    for (const char* word :
         {"sample",    "patch",   "buffer",     "shared",  "smooth",   "flat",      "uint",
          "double",    "dmat4",   "subroutine", "precise", "coherent", "restrict",  "readonly",
          "writeonly", "image2D", "usampler2D", "switch",  "case",     "default",   "layout",
          "common",    "filter",  "input",      "output",  "active",   "partition", "resource"}) {
        const std::string name(word);
        const TranslatedProgram translated = translateSingle(
            Stage::fragment,
            fmt::format("#version 120\nuniform float {0};\nfloat f(float {0}) {{ return {0} * 2.; "
                        "}}\nvoid main() {{ gl_FragColor = vec4(f({0})); }}",
                        name));
        EXPECT_EQ("glsl-W05", ids(translated.diagnostics)) << name;
        EXPECT_EQ("", glslangErrors(translated)) << name;
    }
}

TEST(Reserved, StructMembersAndFunctionsAreRenamedToo) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nstruct S { float input; };\nS filter(S s) { s.input *= 2.; return s; "
                        "}\nvoid main() { S s; s.input = 1.; gl_FragColor = vec4(filter(s).input); }");
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Reserved, QualifierUseIsNotAName) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\n#extension GL_EXT_gpu_shader4 : enable\nflat varying vec3 v;\nvoid "
                        "main() { gl_FragColor = vec4(v, 1.); }");
    EXPECT_FALSE(has(translated.diagnostics, "glsl-W05"));
}

TEST(Reserved, WordTakenInTheDeclaredVersionIsLeftToTheDriver) {
    EXPECT_FALSE(
        has(translateSingle(Stage::fragment,
                            "#version 400\nuniform float sample;\nout vec4 o; void main() { o = vec4(1.); }")
                .diagnostics,
            "glsl-W05"));
}

TEST(Reserved, RenameConnectsTheStages) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvarying float buffer;\nvoid main() { buffer = 1.; gl_Position = gl_Vertex; }\n"},
         {Stage::fragment,
          "#version 120\nvarying float buffer;\nvoid main() { gl_FragColor = vec4(buffer); }\n"}});
    EXPECT_FALSE(has(translated.diagnostics, "glsl-W11"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Reserved, VariableNamedLikeAnEmittedFunctionIsRenamed) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nuniform sampler2D texture;\nvoid main() { vec4 textureLod = "
                        "texture2D(texture, vec2(.5)); gl_FragColor = textureLod; }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "texture(glibra_texture, vec2(.5))"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Reserved, UsersFunctionWinsOverABuiltinOne) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nvec3 noise3(vec3 p) { return p; }\nfloat round(float x) { return "
                        "floor(x + .5); }\nmat2 inverse(mat2 m) { return m; }\nvoid main() { gl_FragColor = "
                        "vec4(noise3(vec3(1.)), round(.5)) * inverse(mat2(1.))[0].x; }");
    EXPECT_EQ(std::string::npos, sourceOf(translated, Stage::fragment).find("glibra_noise3"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Dialects, LaterSyntaxWorksInEveryVersion) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 110\nconst float w[3] = { 1., 2., 3. };\nvoid main() { float a = 1; int b "
                        "= 7 % 4 | 8 >> 1; float c = 1.0f; gl_FragColor = vec4(a + b, c, w[1], 1); }");
    EXPECT_EQ("", glslangErrors(translated));
}

}  // namespace
}  // namespace glibra::glsl::test
