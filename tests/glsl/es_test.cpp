// Programs in GLSL ES 3.00, which glslangValidator compiles and links as a second opinion.

#include "glsl/es/es.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "glsl/emit/log.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

const std::string kVertex = "#version 400\nvoid main() { gl_Position = aVertex; }\n";

struct Written {
    TranslatedProgram core;
    EsProgram es;

    explicit Written(Stages stages) : core(translateStages(std::move(stages))) {
        EXPECT_FALSE(hasError(core.diagnostics))
            << (core.diagnostics.empty() ? "" : core.diagnostics[0].text);
        es = toEs(core);
    }
    /// Of a fragment stage whose main is these statements.
    static Written fragment(const std::string& declarations, const std::string& statements) {
        return Written({{Stage::vertex, kVertex},
                        {Stage::fragment, "#version 400\nout vec4 c;\n" + declarations +
                                              "\nvoid main() { c = vec4(1); " + statements + " }\n"}});
    }
    [[nodiscard]] std::string source(Stage stage) const {
        for (const TranslatedStage& each : es.stages)
            if (each.stage == stage) return each.source;
        return {};
    }
    [[nodiscard]] std::string errors() const {
        TranslatedProgram program;
        program.stages = es.stages;
        return glslangErrors(program);
    }
    [[nodiscard]] std::vector<double> initial(const std::string& name) const {
        const auto found = std::ranges::find(es.initialValues, name, &InitialValue::uniform);
        return found == es.initialValues.end() ? std::vector<double>{} : found->numbers;
    }
};

/// Expects that the fragment stage compiles without a word, and has the tokens.
void expectFragment(const std::string& declarations, const std::string& statements,
                    const std::string& wanted) {
    const Written written = Written::fragment(declarations, statements);
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    EXPECT_TRUE(hasTokens(written.source(Stage::fragment), wanted)) << written.source(Stage::fragment);
}

TEST(Es, IntegersAreConvertedWhereGlslDoesSoItself) {
    struct Case {
        const char *declarations, *statements, *wanted;
    };
    const std::vector<Case> cases{
        {"uniform int n;", "c.x = n;", "c.x = float(n);"},
        {"uniform int n;", "float x = n, y = 2;", "float x = float(n), y = float(2);"},
        {"uniform int n;", "c.x *= n + 1;", "c.x *= float(n + 1);"},
        // The quotient is one of integers, whatever follows.
        {"uniform int n;", "c.x = n / 2 * c.y;", "c.x = float(n / 2) * c.y;"},
        {"uniform int n;", "c.x = c.y * n / 2;", "c.x = c.y * float(n) / float(2);"},
        {"uniform ivec2 p;", "c.xy = c.zw * p;", "c.xy = c.zw * vec2(p);"},
        {"uniform int n;", "if (c.x > n) c.y = 0.;", "c.x > float(n)"},
        {"uniform uint u;", "uint k = u + 1; c.x = float(k);", "uint k = u + uint(1);"},
        {"uniform bool b;", "c.x = b ? 1 : .5;", "b ? float(1) : .5"},
        {"float f(float x, vec2 y) { return x + y.x; }", "c.x = f(1, c.xy);", "f(float(1), c.xy)"},
        {"float f() { return 1; }", "c.x = f();", "return float(1);"},
        {"struct S { float a; vec2 b; };", "S s = S(1, c.xy); c.x = s.a;", "S(float(1), c.xy)"},
        {"", "float a[2] = float[2](1, .5); c.x = a[0];", "float[2](float(1), .5)"},
        {"", "float a[2] = { 1, 2 }; c.x = a[0];", "float[](float(1), float(2))"},
        {"const float kList[2] = float[](1, 2);", "c.x = kList[1];", "float[](float(1), float(2))"},
        {"uniform sampler2D s;", "c = textureLod(s, c.xy, 0);", "textureLod(s, c.xy, float(0))"},
        {"uniform sampler2D s;", "c = texelFetch(s, ivec2(1), 0);", "texelFetch(s, ivec2(1), 0)"},
        {"uniform sampler2D s;", "c = textureLodOffset(s, c.xy, 1, ivec2(1));",
         "textureLodOffset(s, c.xy, float(1), ivec2(1))"},
        {"uniform ivec2 p;", "bvec2 b = lessThan(p, c.xy); c.x = float(b.x);", "lessThan(vec2(p), c.xy)"},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.statements);
        expectFragment(each.declarations, each.statements, each.wanted);
    }
}

TEST(Es, VariablesGetTheirFirstValuesInMain) {
    expectFragment(
        "uniform float u; float twice = u * 2, four = 4.; vec2 two[2] = vec2[2](vec2(u), vec2(1.));",
        "c.x = twice + four + two[0].x;",
        "float twice; void glibra_begin_twice() { twice = u * float(2); } float four = 4.;");
    const Written written = Written::fragment("uniform float u; float twice = u * 2.;", "c.x = twice;");
    EXPECT_TRUE(hasTokens(written.source(Stage::fragment), "void main() { glibra_begin_twice();"));
}

TEST(Es, ValuesOfUniformsAreGivenToWhoeverDraws) {
    const Written written = Written::fragment(
        "const float kHalf = 1. / 2.; uniform float a = -kHalf, b = 3; uniform vec3 v = vec3(.25); uniform "
        "float none = 1 / 2 * .5; uniform "
        "mat2 m = "
        "mat2(2.); uniform bool on = true; uniform int list[2] = int[2](3, 4); struct L { vec2 p; float q; "
        "}; uniform "
        "L lights[2] = L[2](L(vec2(1., 2.), 3.), L(vec2(4.), 5.));",
        "c.x = a + b + none + v.x + m[0][0] + float(list[0]) + lights[1].q; if (on) c.y = 0.;");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    using Numbers = std::vector<double>;
    EXPECT_EQ(written.initial("a"), Numbers{-.5});
    EXPECT_EQ(written.initial("b"), Numbers{3});
    EXPECT_EQ(written.initial("v"), (Numbers{.25, .25, .25}));
    EXPECT_EQ(written.initial("none"), Numbers{0});
    EXPECT_EQ(written.initial("m"), (Numbers{2, 0, 0, 2}));
    EXPECT_EQ(written.initial("on"), Numbers{1});
    EXPECT_EQ(written.initial("list"), (Numbers{3, 4}));
    EXPECT_EQ(written.initial("lights[0].p"), (Numbers{1, 2}));
    EXPECT_EQ(written.initial("lights[1].q"), Numbers{5});
    const Written unknown = Written::fragment("uniform float a = sin(1.);", "c.x = a;");
    EXPECT_EQ(ids(unknown.es.diagnostics), "web-E05");
    EXPECT_EQ(placeOf(unknown.es.diagnostics, "web-E05").line, 3);
}

TEST(Es, StagesAreConnectedWithoutBlocksAndLocations) {
    const Written written(
        {{Stage::vertex,
          "#version 400\nout Surface { vec3 normal; flat int face; } surface;\nlayout(location = 1) out vec2 "
          "vA;\n"
          "out vec4 vPlain; out int vNumber;\nvoid main() { surface.normal = vec3(1.); surface.face = 1; vA "
          "= "
          "vec2(0.); vPlain = vec4(1.); vNumber = 2; gl_Position = aVertex; }\n"},
         {Stage::fragment,
          "#version 400\nin Surface { vec3 normal; flat int face; };\nlayout(location = 1) in vec2 vB;\n"
          "flat in vec4 vPlain; flat in int vNumber; out vec4 c;\n"
          "void main() { c = vec4(normal, face) + vB.xyxy + vPlain + float(vNumber); }\n"}});
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    EXPECT_TRUE(hasTokens(written.source(Stage::vertex), "out vec3 glibra_Surface_normal;"));
    EXPECT_TRUE(hasTokens(written.source(Stage::fragment), "flat in int glibra_Surface_face;"));
    EXPECT_TRUE(hasTokens(written.source(Stage::vertex), "flat out vec4 vPlain;"));
}

TEST(Es, WhatTheCoreProfileHasBesidesIsWrittenInOtherWays) {
    expectFragment("uniform sampler1D s;", "c = texture(s, .5); c.x += float(textureSize(s, 0));",
                   "texture(s, vec2(.5, .5))");
    expectFragment("", "c.x = fma(c.x, c.y, c.z);", "glibra_fma(c.x, c.y, c.z)");
    expectFragment("uniform int n;", "c.x = float(findMSB(n) + bitCount(5u));", "glibra_findMSB(n)");
    expectFragment("float mix(float a, int b) { return a; }", "c.x = mix(1., 2);", "glibra_own_mix(1., 2)");
    expectFragment("precision mediump float; uniform mediump float u;", "lowp float x = u; c.x = x;",
                   "float x = u;");
    const Written points({{Stage::vertex, kVertex}, {Stage::fragment, kPlainFragment}});
    EXPECT_TRUE(hasTokens(points.source(Stage::vertex), "gl_PointSize = glibra_PointSize;"));
}

TEST(Es, WhatItLacksIsSaidAtTheUsersPlace) {
    struct Case {
        const char *declarations, *statements, *id;
        int line;
    };
    const std::vector<Case> cases{
        {"uniform sampler2D s;", "c = textureGather(s, c.xy);", "web-E02", 4},
        {"", "c.x = float(gl_PrimitiveID);", "web-E02", 4},
        {"uniform samplerBuffer s;", "c = texelFetch(s, 1);", "web-E03", 3},
        {"uniform sampler2DMS s;", "c = texelFetch(s, ivec2(1), 1);", "web-E03", 3},
        {"uniform double d;", "c.x = float(d);", "web-E03", 3},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.statements);
        const Written written = Written::fragment(each.declarations, each.statements);
        EXPECT_EQ(ids(written.es.diagnostics), each.id);
        const Place place = placeOf(written.es.diagnostics, each.id);
        EXPECT_EQ(place.file, "a.frag");
        EXPECT_EQ(place.line, each.line);
    }
    const Written flown({{Stage::vertex,
                          "#version 400\nnoperspective out vec2 v;\nvoid main() { v = vec2(1.); "
                          "gl_Position = aVertex; }\n"},
                         {Stage::fragment,
                          "#version 400\nnoperspective in vec2 v; out vec4 c;\nvoid main() { c = "
                          "v.xyxy; }\n"}});
    EXPECT_EQ(ids(flown.es.diagnostics), "web-E04 web-E04");
    const Written geometry({{Stage::vertex, kVertex},
                            {Stage::geometry,
                             "#version 400\nlayout(triangles) in; layout(points, max_vertices = 1) "
                             "out;\nvoid main() { gl_Position = "
                             "gl_in[0].gl_Position; EmitVertex(); }\n"},
                            {Stage::fragment, kPlainFragment}});
    EXPECT_EQ(ids(geometry.es.diagnostics), "web-E01");
    EXPECT_EQ(placeOf(geometry.es.diagnostics, "web-E01").file, "a.geom");
}

TEST(Es, LinesAreThoseOfTheUser) {
    const Written written = Written::fragment("uniform float u;\n\nfloat twice = u * 2.;", "c.x = twice;");
    const auto stage = std::ranges::find(written.es.stages, Stage::fragment, &TranslatedStage::stage);
    ASSERT_NE(stage, written.es.stages.end());
    ASSERT_EQ(stage->lineMap.lines.size(), static_cast<std::size_t>(std::ranges::count(stage->source, '\n')));
    // What a browser says about that line
    const Diagnostics found = explainCompileLog(written.core, *stage, "ERROR: 0:5: 'twice' : no such thing");
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].place.line, 5);
    EXPECT_EQ(found[0].place.file, "a.frag");
}

}  // namespace
}  // namespace glibra::glsl::test
