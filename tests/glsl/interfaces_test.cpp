// Variables and blocks between stages, samplers and subroutines (language, 7.9).

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram pair(const std::string& vertexText, const std::string& fragmentText) {
    return translateStages({{Stage::vertex, "#version 330\n" + vertexText},
                            {Stage::fragment, "#version 330\nout vec4 fColor;\n" + fragmentText}});
}

TEST(Interface, UnwrittenInputReadsZero) {
    const TranslatedProgram translated = pair("void main() { gl_Position = aVertex; }",
                                              "in vec3 vECposition; flat in int n; in vec2 a[2];\nvoid "
                                              "main() { fColor = vec4(vECposition, float(n) + a[1].x); }");
    EXPECT_EQ("glsl-W11 glsl-W11 glsl-W11", ids(translated.diagnostics));
    EXPECT_EQ("'vECposition' is written by no earlier stage, it reads 0", translated.diagnostics[0].text);
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::fragment),
                  "vec3 vECposition = vec3(0.); int n = 0; vec2 a[2] = vec2[2](vec2(0.), vec2(0.));"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Interface, UnwrittenInputNamesTheWrittenOutputThatIsNearest) {
    const auto textOf = [](const std::string& outputs, const std::string& input) {
        const TranslatedProgram translated =
            pair(outputs + " void main() { vNormal = vec3(1.); gl_Position = aVertex; }",
                 "in vec3 " + input + "; void main() { fColor = vec4(" + input + ", 1.); }");
        return translated.diagnostics.empty() ? "" : translated.diagnostics[0].text;
    };
    EXPECT_EQ("'vNorml' is written by no earlier stage, it reads 0; did you mean 'vNormal'?",
              textOf("out vec3 vNormal; out vec3 vNorm;", "vNorml"))
        << "nothing writes vNorm";
    EXPECT_EQ("'vColor' is written by no earlier stage, it reads 0", textOf("out vec3 vNormal;", "vColor"));
}

TEST(Interface, DeclaredButUnwrittenOutputCountsAsUnwritten) {
    EXPECT_EQ("glsl-W11", ids(pair("out vec3 v; void main() { gl_Position = aVertex; }",
                                   "in vec3 v; void main() { fColor = vec4(v, 1.); }")
                                  .diagnostics));
}

TEST(Interface, UnusedUnwrittenInputIsSilent) {
    EXPECT_EQ("", ids(pair("void main() { gl_Position = aVertex; }",
                           "in vec3 v; void main() { fColor = vec4(1.); }")
                          .diagnostics));
}

TEST(Interface, EveryWayOfWritingCounts) {
    for (const char* write : {"v = vec3(1.);", "v.x = 1.;", "v[0] += 1.;", "v.z++;", "--v.x;", "set(v);",
                              "set((v));", "modf(1.5, v.x);", "(v).xy = vec2(1.);"})
        EXPECT_EQ("", ids(pair("out vec3 v; void set(out vec3 a) { a = vec3(1.); } void main() { gl_Position "
                               "= aVertex; " +
                                   std::string(write) + " }",
                               "in vec3 v; void main() { fColor = vec4(v, 1.); }")
                              .diagnostics))
            << write;
}

TEST(Interface, ReadingIsNotWriting) {
    for (const char* read : {"if (v == vec3(1.)) gl_Position.x = 1.;", "if (v.x > 0.) ++gl_Position.x;",
                             "get(v);", "gl_Position.x = v.x;", "gl_Position[int(v.x)] = 1.;"})
        EXPECT_EQ("glsl-W11",
                  ids(pair("out vec3 v; void get(vec3 a) { } void main() { gl_Position = aVertex; " +
                               std::string(read) + " }",
                           "in vec3 v; void main() { fColor = vec4(v, 1.); }")
                          .diagnostics))
            << read;
}

TEST(Interface, TypesMustAgree) {
    const TranslatedProgram translated =
        pair("out vec3 vN; void main() { vN = vec3(1.); gl_Position = aVertex; }",
             "\nin vec4 vN; void main() { fColor = vN; }");
    EXPECT_EQ("'vN' is vec3 in a.vert:2 and vec4 in a.frag:4", textOf(translated.diagnostics, "glsl-E02"));
}

TEST(Interface, ArraySizesMustAgree) {
    EXPECT_TRUE(has(pair("out float v[2]; void main() { v[0] = 1.; gl_Position = aVertex; }",
                         "in float v[3]; void main() { fColor = vec4(v[0]); }")
                        .diagnostics,
                    "glsl-E02"));
    EXPECT_EQ("", ids(pair("out float[2] v; void main() { v[0] = 1.; gl_Position = aVertex; }",
                           "in float v[2]; void main() { fColor = vec4(v[0]); }")
                          .diagnostics));
}

TEST(Interface, LocationsConnectDifferentNames) {
    const TranslatedProgram translated =
        pair("layout(location = 2) out vec3 a; void main() { a = vec3(1.); gl_Position = aVertex; }",
             "layout(location = 2) in vec3 b; void main() { fColor = vec4(b, 1.); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Interface, LocationOfOneSideGivesWayToTheName) {
    const TranslatedProgram translated =
        pair("layout(location = 2) out vec3 a; void main() { a = vec3(1.); gl_Position = aVertex; }",
             "in vec3 a; void main() { fColor = vec4(a, 1.); }");
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::vertex), "330 out vec3 a;") ||
                hasTokens(userPart(translated, Stage::vertex), "out vec3 a;"));
    EXPECT_EQ(std::string::npos, userPart(translated, Stage::vertex).find("layout"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Interface, UnwrittenBlocksReadZero) {
    const TranslatedProgram open =
        pair("void main() { gl_Position = aVertex; }",
             "in Data { vec3 n; vec2 t[2]; };\nvoid main() { fColor = vec4(n, t[1].x); }");
    EXPECT_EQ("glsl-W11", ids(open.diagnostics));
    EXPECT_EQ("", glslangErrors(open));
    const TranslatedProgram named =
        pair("void main() { gl_Position = aVertex; }",
             "in Data { vec3 n; flat int i; } d;\nvoid main() { fColor = vec4(d.n, float(d.i)); }");
    EXPECT_EQ("glsl-W11", ids(named.diagnostics));
    EXPECT_EQ("", glslangErrors(named));
}

TEST(Interface, BlocksConnectByName) {
    const TranslatedProgram translated =
        pair("out Data { vec3 n; } o; void main() { o.n = vec3(1.); gl_Position = aVertex; }",
             "in Data { vec3 n; } i;\nvoid main() { fColor = vec4(i.n, 1.); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Interface, UnwrittenGeometryAndTessellationInputs) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex, kPlainVertex},
         {Stage::tessEvaluation,
          "#version 400\nlayout(triangles) in;\nin vec3 a[]; patch in float p;\nvoid main() { gl_Position = "
          "vec4(a[2], p); }\n"},
         {Stage::geometry,
          "#version 400\nlayout(triangles) in; layout(points, max_vertices = 1) out;\nin vec2 b[];\nvoid "
          "main() { gl_Position = vec4(b[2], b.length(), 1.); EmitVertex(); }\n"},
         {Stage::fragment, kPlainFragment}});
    EXPECT_EQ("glsl-W11 glsl-W11 glsl-W11", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Interface, MissingPositionIsReported) {
    EXPECT_EQ("a.vert never writes gl_Position",
              textOf(pair("void main() { }", "void main() { fColor = vec4(1.); }").diagnostics, "glsl-W14"));
}

TEST(Interface, PositionsThatALaterStageMakesAreNotMissing) {
    const auto drawn = [](const std::string& place) {
        return translateStages(
            {{Stage::vertex, "#version 400\nout vec3 vPlace;\nvoid main() { vPlace = aVertex.xyz; }\n"},
             {Stage::geometry,
              "#version 400\nlayout(triangles) in; layout(points, max_vertices = 1) out;\nin vec3 vPlace[];\n"
              "void main() { gl_Position = " +
                  place + "; EmitVertex(); }\n"},
             {Stage::fragment, kPlainFragment}});
    };
    EXPECT_EQ("", ids(drawn("vec4(vPlace[0], 1.)").diagnostics));
    EXPECT_EQ("glsl-W14", ids(drawn("gl_in[0].gl_Position + vec4(vPlace[0], 0.)").diagnostics));
}

TEST(Samplers, NumberBecomesTheSamplerTheFunctionNames) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nuniform int uTexUnit, other;\nvoid main() { gl_FragColor = "
                        "texture3D(uTexUnit, vec3(.5)) * float(other); }");
    EXPECT_EQ("'uTexUnit' is int, used as sampler3D", textOf(translated.diagnostics, "glsl-W12"));
    EXPECT_TRUE(
        hasTokens(userPart(translated, Stage::fragment), "uniform sampler3D uTexUnit; uniform int other;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Samplers, ScenesTexturesDecideForGenericFunctions) {
    ProgramRequest request = single(
        Stage::fragment, "uniform float u = 5; out vec4 o;\nvoid main() { o = texture(u, vec3(.5)); }");
    std::string asked;
    request.samplerKindsOfTag = [&](std::string_view tag) {
        asked = tag;
        return std::vector{SamplerKind::samplerCube};
    };
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("u", asked);
    EXPECT_EQ("glsl-W12", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "uniform samplerCube u;"));
    EXPECT_EQ(5, translated.textureBindings.at("u"));
    request.samplerKindsOfTag = [](std::string_view) {
        return std::vector{SamplerKind::sampler2D, SamplerKind::samplerCube};
    };
    EXPECT_NE(std::string::npos, textOf(translate(request).diagnostics, "glsl-E08").find("2D and cube"));
    request.samplerKindsOfTag = nullptr;
    EXPECT_TRUE(has(translate(request).diagnostics, "glsl-E08"));
}

TEST(Samplers, AllStagesAreRetyped) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nuniform int t; void main() { gl_Position = texture2DLod(t, vec2(0.), 0.); }\n"},
         {Stage::fragment,
          "#version 120\nuniform int t; void main() { gl_FragColor = texture2D(t, vec2(.5)); }\n"}});
    EXPECT_EQ("glsl-W12 glsl-W12", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Samplers, BindingsAreFacts) {
    EXPECT_EQ(7, translateSingle(Stage::fragment,
                                 "#version 420\nlayout(binding = 7) uniform sampler2D s; out vec4 o; void "
                                 "main() { o = texture(s, vec2(0.)); }")
                     .textureBindings.at("s"));
}

TEST(Subroutines, BecomeNumbersOfFunctions) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 400\nsubroutine vec4 Shade(float x);\nsubroutine uniform Shade shade;\nout "
                        "vec4 o;\nvoid main() { o = shade(1.); }\nsubroutine(Shade) vec4 phong(float x) { "
                        "return vec4(x); }\nsubroutine(Shade) vec4 flatOne(float x) { return vec4(0.); }\n");
    EXPECT_EQ(translated.uniforms.at("shade").subroutines, (std::vector<std::string>{"phong", "flatOne"}));
    EXPECT_EQ(std::string::npos, sourceOf(translated, Stage::fragment).find("subroutine"));
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Subroutines, MayBeArraysReturnNothingAndHaveNamesOfKeywords) {
    const TranslatedProgram translated = translateSingle(Stage::fragment, R"(#version 400
subroutine void Work(inout vec4 color, const in float list[2]);
subroutine float Next();
layout(location = 2) subroutine uniform Work works[2];
subroutine uniform Next next, other;
subroutine(Work) void shared(inout vec4 color, const in float list[2]) { color.r = list[0]; }
layout(index = 7) subroutine(Work) void twice(inout vec4 color, const in float list[2]) { color *= list[1]; }
subroutine(Next) float one() { return 1.; }
out vec4 o;
void main() {
    o = vec4(next(), other(), 0., 1.);
    works[1](o, float[2](1., next()));
    for (int i = 0; i < 2; ++i) works[i](o, float[2](1., 2.));
}
)");
    EXPECT_EQ(translated.uniforms.at("works").subroutines, (std::vector<std::string>{"shared", "twice"}));
    EXPECT_EQ(translated.uniforms.at("other").subroutines, (std::vector<std::string>{"one"}));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Subroutines, AreCountedOverAllStages) {
    const std::string type = "subroutine float F(float x);\nsubroutine uniform F f;\n";
    const TranslatedProgram translated = pair(
        type +
            "subroutine(F) float a(float x) { return x; }\nsubroutine(F) float b(float x) { return x; }\n"
            "out float v;\nvoid main() { gl_Position = aVertex; v = f(1.); }",
        "in float v;\n" + type +
            "subroutine(F) float b(float x) { return x; }\nsubroutine(F) float c(float x) { return x; }\n"
            "void main() { fColor = vec4(f(v)); }");
    EXPECT_EQ(translated.uniforms.at("f").subroutines, (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_NE(std::string::npos, sourceOf(translated, Stage::fragment).find("glibra_which == 2"));
}

TEST(Buffers, AreRefused) {
    EXPECT_EQ(
        "buffer block 'Pos': scenes have no storage buffers",
        textOf(
            translateSingle(
                Stage::vertex,
                "#version 430\nlayout(std430) buffer Pos { vec4 p[]; };\nvoid main() { gl_Position = p[0]; }")
                .diagnostics,
            "glsl-E09"));
    EXPECT_TRUE(
        has(translateSingle(Stage::vertex,
                            "#version 420\nlayout(binding = 0) uniform atomic_uint c;\nvoid main() { }")
                .diagnostics,
            "glsl-E09"));
}

TEST(Facts, UniformsWithPlacesAndInitialisers) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 330\nuniform float uA = 1.,\n  uB;\nuniform Block { vec4 uC; };\nout vec4 "
                        "o; void main() { o = uA + uB * uC; }");
    EXPECT_TRUE(translated.uniforms.at("uA").hasInitializer);
    EXPECT_FALSE(translated.uniforms.at("uB").hasInitializer);
    EXPECT_EQ(3, translated.uniforms.at("uB").place.line);
    EXPECT_EQ(3, translated.uniforms.at("uB").place.column);
    EXPECT_TRUE(translated.uniforms.contains("uC"));
    EXPECT_TRUE(translated.uniforms.contains("Block.uC"));
}

}  // namespace
}  // namespace glibra::glsl::test
