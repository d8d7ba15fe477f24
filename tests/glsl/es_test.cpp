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
        {"", "c.x = float(gl_SampleID);", "web-E02", 4},
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
    const Written patches({{Stage::vertex, kVertex},
                           {Stage::tessEvaluation,
                            "#version 400\nlayout(triangles) in;\nvoid main() { gl_Position = "
                            "gl_in[0].gl_Position; }\n"},
                           {Stage::fragment, kPlainFragment}});
    const Diagnostics refused = toEs(patches.core, {.draws = {.patchVertices = 0}}).diagnostics;
    EXPECT_EQ(ids(refused), "web-E01");
    EXPECT_EQ(placeOf(refused, "web-E01").file, "a.tese");
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

// Geometry stages become a part of the vertex stage.

struct WithGeometry : Written {
    WithGeometry(const std::string& vertex, const std::string& geometry, const std::string& fragment)
        : Written({{Stage::vertex, "#version 400\n" + vertex},
                   {Stage::geometry, "#version 400\n" + geometry},
                   {Stage::fragment, "#version 400\n" + fragment}}) {}
};

// Mesa leaves out which source a line of GLSL ES is of, and browsers leave out the column.
TEST(Es, MessagesAboutStagesThatRunInTheVertexStageNameTheirFiles) {
    const std::string geometry =
        "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out; // not gl_TessCoord\n"
        "float twice(float x) { return 2. * x; }\nvoid main() { for (int i = 0; i < 3; ++i) {\n"
        "    gl_Position = twice(.5) * gl_in[i].gl_Position * wrong; EmitVertex(); } }";
    const WithGeometry written(
        "float thrice(float x) { return 3. * x; } void main() { gl_Position = aVertex * thrice(1.); }",
        geometry, "out vec4 c; void main() { c = vec4(1.); }");
    const TranslatedStage& merged = written.es.stages.front();
    std::size_t number = 0, column = 0;
    for (std::size_t at = 0, end = 0; at < merged.source.size(); at = end + 1) {
        end = merged.source.find('\n', at);
        const std::string line = merged.source.substr(at, end - at);
        column = line.find("wrong") + 1;
        if (column > 0) break;
        number = line.starts_with("#line ") ? std::stoul(line.substr(6)) : number + 1;
    }
    ASSERT_GT(column, 0U) << merged.source;
    const std::string line = std::to_string(number);
    for (const std::string& log :
         {"0:" + line + "(" + std::to_string(column) + "): error: `wrong' undeclared\n",
          "ERROR: 1:" + line + ": 'wrong' : undeclared identifier\n"}) {
        const Diagnostics found = explainCompileLog(written.core, merged, log);
        ASSERT_FALSE(found.empty()) << log;
        EXPECT_EQ(found[0].place, (Place{"a.geom", 5, 54})) << toString(found[0]) << "\n" << merged.source;
    }
    TranslatedProgram named = written.core;
    named.userNames.insert(written.es.userNames.begin(), written.es.userNames.end());
    const Diagnostics call = explainCompileLog(
        named, merged, "0:" + line + "(1): error: no matching function for `glibra_v_thrice(int)'\n");
    EXPECT_EQ(call.at(0).text, "no matching function for `thrice(int)'") << merged.source;
}

/// True if the text has a guard that costs so many rounds.
bool guards(const std::string& text, int rounds) {
    return text.find("(glibra_rounds += " + std::to_string(rounds) + ") <= glibra_Rounds") !=
           std::string::npos;
}

TEST(Es, LoopsThatTheTextDoesNotProveShortAreGuarded) {
    const std::string declarations =
        "uniform int n; float deep(float x) { for (int i = 0; i < 100; ++i) x = fract(x + .1); return x; }";
    for (const auto& [loop, rounds] : {std::pair("while (true) c += .1;", 1),
                                       {"for (;;) if (c.x > 9.) break; else c += .1;", 1},
                                       {"for (int i = 0; i < n; ++i) c += .1;", 1},
                                       {"for (int i = 0; i < 5000; ++i) c += .1;", 1},
                                       {"do c += deep(c.x); while (c.x < 9.);", 101},
                                       {"for (int i = 0; i < 99; ++i) c += deep(deep(c.x));", 201},
                                       {"while (c.x < 9.) for (int i = 0; i < 40; ++i) c += .1;", 41},
                                       {"while (bool goes = c.x < 9.) c += goes ? .1 : .2;", 1}}) {
        const Written written = Written::fragment(declarations, loop);
        EXPECT_EQ(written.errors(), "") << loop << written.source(Stage::fragment);
        EXPECT_TRUE(guards(written.source(Stage::fragment), rounds))
            << loop << written.source(Stage::fragment);
        ASSERT_EQ(written.es.loopSites.size(), 1U) << loop;
        EXPECT_EQ(written.es.loopSites[0].line, 4) << loop;
    }
    for (const char* loop :
         {"for (int i = 0; i < 4096; ++i) c += .1;", "for (int i = 0; i < 32; ++i) c += deep(c.x);",
          "for (int i = 0; i < 60; ++i) for (int j = 0; j < 60; ++j) c += .1;", "c += .1;"}) {
        const Written written = Written::fragment(declarations, loop);
        EXPECT_EQ(written.source(Stage::fragment).find("glibra_rounds"), std::string::npos) << loop;
        EXPECT_TRUE(written.es.loopSites.empty()) << loop;
    }
}

TEST(Es, GuardedLoopsOfStagesInTheVertexStageAreShownByTheFragmentStage) {
    const std::string loop = "uniform float u; float far(float x) { while (x < u) x += 1.; return x; }\n";
    for (const bool isLast : {false, true}) {
        const WithGeometry written(
            (isLast ? "" : loop) + "void main() { gl_Position = aVertex * " + (isLast ? "1." : "far(0.)") +
                "; }",
            "layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n" + (isLast ? loop : "") +
                "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position * " +
                (isLast ? "far(0.)" : "1.") + "; EmitVertex(); } }",
            "out vec4 c; void main() { c = vec4(1.); }");
        EXPECT_EQ(written.errors(), "");
        EXPECT_EQ(written.es.loopSites.size(), 1U);
        EXPECT_NE(written.es.stages.back().source.find("flat in int glibra_vertexCut"), std::string::npos);
    }
}

TEST(Es, GeometryStagesRunInTheVertexStage) {
    const WithGeometry written(
        "out vec3 vColor; float twice(float x) { return 2. * x; }\n"
        "void main() { vColor = vec3(twice(.5)); gl_Position = aVertex; }",
        "layout(triangles, invocations = 2) in; layout(triangle_strip, max_vertices = 4) out;\n"
        "in vec3 vColor[]; out vec3 gColor; float twice(float x) { return x + x; }\n"
        "void main() { for (int i = 0; i < gl_in.length(); ++i) { gColor = vColor[i] * twice(.5) * "
        "float(gl_InvocationID + gl_PrimitiveIDIn); gl_Position = gl_in[i].gl_Position; EmitVertex(); } "
        "EndPrimitive(); }",
        "in vec3 gColor; out vec4 c; void main() { c = vec4(gColor, 1.); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    ASSERT_EQ(written.es.stages.size(), 2U);
    // Two triangles of four vertices, in two invocations.
    EXPECT_EQ(written.es.expanded.corners, 3);
    EXPECT_EQ(written.es.expanded.vertices, 12);
    EXPECT_EQ(written.es.expanded.ofPrimitive, 3);
    EXPECT_TRUE(
        hasTokens(written.source(Stage::vertex), "layout(location = 2) in vec4 glibra_Corner2_aVertex;"))
        << written.source(Stage::vertex);
}

TEST(Es, GeometryStagesPassBlocksPointsAndNumbers) {
    const WithGeometry written(
        "out Data { vec3 color; float size; } to; void main() { to.color = vec3(gl_VertexID); to.size = 3.; "
        "gl_Position = vec4(0.); }",
        "layout(points) in; layout(points, max_vertices = 1) out; in Data { vec3 color; float size; } "
        "from[];\n"
        "out Data { vec3 color; } to; void main() { to.color = from[0].color; gl_PrimitiveID = 7; "
        "gl_PointSize = "
        "from[0].size; gl_Position = gl_in[0].gl_Position; EmitVertex(); }",
        "in Data { vec3 color; } to; out vec4 c; void main() { c = vec4(to.color, float(gl_PrimitiveID)); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    EXPECT_EQ(written.es.expanded.vertices, 1);
}

TEST(Es, TooManyInputsOfAGeometryStageAreFetched) {
    const WithGeometry written(
        "in vec4 a, b, d; in ivec2 e; out vec4 v; void main() { v = a + b + d + vec4(e, 0, 0); gl_Position = "
        "aVertex; }",
        "layout(triangles_adjacency) in; layout(points, max_vertices = 1) out; in vec4 v[];\n"
        "void main() { gl_Position = v[0]; EmitVertex(); }",
        "out vec4 c; void main() { c = vec4(1.); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    ASSERT_EQ(written.es.expanded.fetched.size(), 5U);
    EXPECT_EQ(ids(toEs(written.core, {.draws = {.haveBufferData = true}}).diagnostics), "web-E01");
}

// So do tessellation stages.

struct WithTessellation : Written {
    WithTessellation(const std::string& vertex, const std::string& control, const std::string& evaluation,
                     const std::string& fragment, const std::string& geometry = {})
        : Written(stages(vertex, control, evaluation, fragment, geometry)) {}
    static Stages stages(const std::string& vertex, const std::string& control, const std::string& evaluation,
                         const std::string& fragment, const std::string& geometry) {
        Stages all{{Stage::vertex, "#version 410\n" + vertex}};
        if (!control.empty()) all.push_back({Stage::tessControl, "#version 410\n" + control});
        all.push_back({Stage::tessEvaluation, "#version 410\n" + evaluation});
        if (!geometry.empty()) all.push_back({Stage::geometry, "#version 410\n" + geometry});
        all.push_back({Stage::fragment, "#version 410\n" + fragment});
        return all;
    }
};

TEST(Es, TessellationStagesRunInTheVertexStage) {
    const WithTessellation written(
        "out vec3 vColor; uniform float uSize; float twice(float x) { return 2. * x; }\n"
        "void main() { vColor = vec3(twice(uSize)); gl_Position = aVertex; }",
        "layout(vertices = 4) out; in vec3 vColor[]; out vec3 tColor[]; patch out vec4 tPatch; uniform float "
        "uSize;\n"
        "float twice(float x) { return x + x; }\n"
        "void main() { tColor[gl_InvocationID] = vColor[gl_InvocationID] * twice(1.);\n"
        "gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
        "barrier(); if (gl_InvocationID == 0) tPatch = vec4(tColor[0], float(gl_PatchVerticesIn + "
        "gl_PrimitiveID));\n"
        "for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = uSize; gl_TessLevelInner[0] = "
        "gl_TessLevelInner[1] = "
        "uSize; }",
        "layout(quads, fractional_odd_spacing, cw) in; in vec3 tColor[]; patch in vec4 tPatch; out vec3 "
        "eColor;\n"
        "float twice(float x) { return 3. * x; }\n"
        "void main() { eColor = tColor[3] * tPatch.xyz * twice(gl_TessLevelOuter[1]); gl_Position = "
        "mix(gl_in[0].gl_Position, gl_in[3].gl_Position, gl_TessCoord.x); }",
        "in vec3 eColor; out vec4 c; void main() { c = vec4(eColor, float(gl_PrimitiveID)); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    ASSERT_EQ(written.es.stages.size(), 2U);
    const ExpandedGeometry& expanded = written.es.expanded;
    EXPECT_EQ(expanded.ofPrimitive, 3);
    EXPECT_TRUE(expanded.measuresLevels);
    ASSERT_TRUE(expanded.tessellation);
    EXPECT_EQ(expanded.tessellation->domain, base::TessellationLayout::Domain::quads);
    EXPECT_EQ(expanded.tessellation->spacing, base::TessellationLayout::Spacing::fractionalOdd);
    EXPECT_TRUE(expanded.tessellation->isClockwise);
    // A barrier makes all invocations run twice.
    EXPECT_TRUE(hasTokens(written.source(Stage::vertex), "for (int run = 0; run < 2; ++run)"));
}

TEST(Es, TessellationStagesPassBlocksAndPrimitives) {
    const WithTessellation written(
        "out Data { vec3 color; } to; void main() { to.color = vec3(gl_VertexID); gl_Position = vec4(0.); }",
        "layout(vertices = 3) out; in Data { vec3 color; } from[]; out Next { vec3 color; float size; } "
        "to[];\n"
        "patch out Whole { vec2 all; } whole; void main() { to[gl_InvocationID].color = "
        "from[gl_InvocationID].color;\n"
        "to[gl_InvocationID].size = 1.; whole.all = vec2(2.);\n"
        "gl_TessLevelOuter[0] = gl_TessLevelOuter[1] = gl_TessLevelOuter[2] = gl_TessLevelInner[0] = 3.; }",
        "layout(triangles) in; in Next { vec3 color; float size; } from[]; patch in Whole { vec2 all; } "
        "whole;\n"
        "out Last { vec3 color; } last; void main() { last.color = from[1].color * from[2].size * "
        "whole.all.x; "
        "gl_Position = vec4(gl_TessCoord, 1.); }",
        "in vec3 gColor; out vec4 c; void main() { c = vec4(gColor, 1.); }",
        "layout(triangles) in; layout(line_strip, max_vertices = 4) out; in Last { vec3 color; } last[]; out "
        "vec3 "
        "gColor;\n"
        "void main() { for (int i = 0; i < 4; ++i) { gColor = last[i % 3].color; gl_Position = gl_in[i % "
        "3].gl_Position; EmitVertex(); } EndPrimitive(); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    EXPECT_EQ(written.es.expanded.vertices, 6);
    EXPECT_EQ(written.es.expanded.ofPrimitive, 2);
}

TEST(Es, PatchesWithoutAControlStageAndPoints) {
    const WithTessellation written("void main() { gl_Position = aVertex; }", "",
                                   "layout(isolines, point_mode) in; void main() { gl_Position = "
                                   "mix(gl_in[0].gl_Position, gl_in[1].gl_Position, "
                                   "gl_TessCoord.x) + float(gl_PatchVerticesIn); }",
                                   "out vec4 c; void main() { c = vec4(1.); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    EXPECT_FALSE(written.es.expanded.measuresLevels);
    EXPECT_EQ(written.es.expanded.ofPrimitive, 1);
}

TEST(Es, WhatCannotBeDrawnRightIsRefused) {
    const WithGeometry written("void main() { gl_Position = aVertex; }",
                               "layout(triangles) in; layout(points, max_vertices = 1) out;\n"
                               "void main() { gl_Position = gl_in[0].gl_Position; EmitVertex(); }",
                               "out vec4 c; void main() { c = vec4(1.); }");
    EXPECT_EQ(ids(toEs(written.core, {.draws = {.areStrips = true}}).diagnostics), "web-E01");
    EXPECT_EQ(ids(toEs(written.core, {.draws = {.haveIndexBuffers = true}}).diagnostics), "web-E01");
    const Written numbered = Written::fragment("", "c.x = float(gl_PrimitiveID);");
    EXPECT_EQ(ids(numbered.es.diagnostics), "");
    EXPECT_EQ(numbered.errors(), "");
    EXPECT_TRUE(numbered.es.expanded.numbersPrimitives);
    EXPECT_EQ(ids(toEs(numbered.core, {.draws = {.haveIndexBuffers = true}}).diagnostics), "web-E02");
    EXPECT_EQ(ids(toEs(numbered.core, {.draws = {.areStrips = true}}).diagnostics), "web-E02");
}

TEST(Es, VariablesOfAFileBeginAnewForEachCorner) {
    const WithGeometry written(
        "int count = 3; vec4 shift = vec4(1.); out vec4 v; void main() { count += 2; v = float(count) * "
        "shift; "
        "gl_Position = aVertex; }",
        "layout(triangles) in; layout(points, max_vertices = 1) out; in vec4 v[];\n"
        "void main() { gl_Position = v[0] + v[2]; EmitVertex(); }",
        "out vec4 c; void main() { c = vec4(1.); }");
    EXPECT_EQ(ids(written.es.diagnostics), "");
    EXPECT_EQ(written.errors(), "");
    const std::string source = written.source(Stage::vertex);
    EXPECT_TRUE(hasTokens(source, "{ glibra_v_count = 3; }")) << source;
    EXPECT_FALSE(hasTokens(source, "{ glibra_v_shift = vec4(1.); }")) << "it does not change";
    EXPECT_EQ(ids(toEs(written.core, {.draws = {.haveInstanceData = true}}).diagnostics), "web-E01");
    const WithTessellation sized("void main() { gl_Position = aVertex; }", "",
                                 "layout(triangles) in; void main() { gl_Position = gl_in[0].gl_Position; }",
                                 "out vec4 c; void main() { c = vec4(1.); }");
    EXPECT_EQ(ids(toEs(sized.core, {.draws = {.patchVertices = 0}}).diagnostics), "web-E01");
}

TEST(Es, ClipDistancesDiscardFragments) {
    for (const char* declared : {"", "out float gl_ClipDistance[2];\n"}) {
        const TranslatedProgram core = translateStages(
            {{Stage::vertex, std::string("#version 410\n") + declared +
                                 "void main() { gl_Position = aVertex; gl_ClipDistance[0] = aVertex.x; "
                                 "gl_ClipDistance[1] = 1.; }\n"},
             {Stage::fragment, "#version 410\nout vec4 c;\nvoid main() { c = vec4(1); }\n"}});
        const EsProgram es = toEs(core);
        EXPECT_EQ(ids(es.diagnostics), "");
        ASSERT_EQ(es.stages.size(), 2U);
        EXPECT_TRUE(hasTokens(es.stages[0].source, "out float glibra_ClipDistance[2];"));
        EXPECT_TRUE(hasTokens(es.stages[1].source,
                              "if (glibra_ClipDistance[0] < 0. || glibra_ClipDistance[1] < 0.) discard;"));
        TranslatedProgram program;
        program.stages = es.stages;
        EXPECT_EQ(glslangErrors(program), "");
    }
    // Each vertex that a geometry stage emits has its own.
    const TranslatedProgram core = translateStages(
        {{Stage::vertex, "#version 410\nvoid main() { gl_Position = aVertex; }\n"},
         {Stage::geometry,
          "#version 410\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n"
          "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position; "
          "gl_ClipDistance[0] = gl_Position.x; EmitVertex(); } }\n"},
         {Stage::fragment, "#version 410\nout vec4 c;\nvoid main() { c = vec4(1); }\n"}});
    const EsProgram es = toEs(core);
    EXPECT_EQ(ids(es.diagnostics), "");
    ASSERT_EQ(es.stages.size(), 2U);
    EXPECT_TRUE(hasTokens(es.stages[0].source, "glibra_ClipDistance = glibra_kept_glibra_ClipDistance;"))
        << es.stages[0].source;
    TranslatedProgram program;
    program.stages = es.stages;
    EXPECT_EQ(glslangErrors(program), "");
}

TEST(Es, BordersAreReadByTheShader) {
    const TranslatedProgram core = translateStages(
        {{Stage::vertex, kVertex},
         {Stage::fragment,
          "#version 400\nuniform sampler2D a; uniform sampler2DShadow s; uniform sampler2D many[2]; out vec4 "
          "c;\n"
          "float lit(sampler2DShadow map, vec4 at) { return textureProj(map, at) + texture(map, at.xyz); }\n"
          "vec4 of(sampler2D map) { return textureLod(map, vec2(1.), 0.); }\n"
          "void main() { c = texture(a, vec2(2.)) + of(a) + of(many[1]) + lit(s, vec4(2.)) + texture(a, "
          "vec2(1.), "
          "-1.) + textureProj(a, vec3(1.)) + textureProj(a, vec4(1.)); }\n"}});
    const EsProgram es = toEs(core, {.hasBorders = true});
    EXPECT_EQ(ids(es.diagnostics), "");
    TranslatedProgram program;
    program.stages = es.stages;
    EXPECT_EQ(glslangErrors(program), "");
    const std::string& text = es.stages.back().source;
    EXPECT_TRUE(hasTokens(text, "uniform vec4 glibra_Border_a[2];")) << text;
    EXPECT_TRUE(hasTokens(text, "glibra_texture(glibra_Border_a, a, vec2(2.))")) << text;
    EXPECT_TRUE(hasTokens(text, "lit(glibra_Border_s, s, vec4(2.))")) << text;
}

TEST(Es, WideLinesAreMadeOfWhatTheFragmentStageReads) {
    const auto made = [&](const std::string& outputs, const std::string& written, const std::string& value) {
        std::string inputs = outputs;
        for (std::size_t at; (at = inputs.find("out ")) != std::string::npos;) inputs.replace(at, 3, "in");
        const TranslatedProgram core =
            translateStages({{Stage::vertex, "#version 400\n" + outputs + "void main() { " + written +
                                                 " gl_Position = aVertex; }\n"},
                             {Stage::fragment, "#version 400\n" + inputs +
                                                   "out vec4 c;\nvoid main() { c = " + value + "; }\n"}});
        EXPECT_EQ(ids(core.diagnostics), "");
        return toEs(core, {.draws = {.haveWideLines = true}});
    };
    const EsProgram es =
        made("out mat2 turn; flat out uvec3 three; out float list[2]; out vec4 unread;\n",
             "turn = mat2(1.); three = uvec3(1u); list[0] = list[1] = 1.; unread = vec4(1.);",
             "vec4(turn[0], float(three.x), list[1])");
    EXPECT_EQ(es.wideLines.captured, (std::vector<std::string>{"gl_Position", "turn", "three", "list"}));
    EXPECT_EQ(es.wideLines.components, 4 + 4 + 3 + 2);
    const std::string& text = es.stages.front().source;
    EXPECT_TRUE(hasTokens(text, "void glibra_vertexMain() {")) << text;
    EXPECT_TRUE(hasTokens(text, "list[1] = float(glibra_lineBetween(12));")) << text;
    EXPECT_TRUE(hasTokens(text, "three = uvec3(glibra_lineWord(glibra_lineLast + 8),")) << text;
    TranslatedProgram program;
    program.stages = es.stages;
    EXPECT_EQ(glslangErrors(program), "");
    EXPECT_TRUE(made("out vec4 many[16];\n", "many[3] = vec4(1.);", "many[3]").wideLines.captured.empty());
    EXPECT_TRUE(
        made("struct S { vec4 a; }; out S s;\n", "s.a = vec4(1.);", "s.a").wideLines.captured.empty());
}

TEST(Es, WideLinesOfPatchesAreCapturedAfterTheirLevels) {
    const TranslatedProgram core = translateStages(
        {{Stage::vertex, kVertex},
         {Stage::tessControl,
          "#version 410\nlayout(vertices = 2) out;\nvoid main() { gl_TessLevelOuter[0] = 1.; "
          "gl_TessLevelOuter[1] = "
          "9.; gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position; }\n"},
         {Stage::tessEvaluation,
          "#version 410\nlayout(isolines) in;\nout float t;\nvoid main() { t = gl_TessCoord.x; gl_Position = "
          "mix(gl_in[0].gl_Position, gl_in[1].gl_Position, t); }\n"},
         {Stage::fragment, "#version 410\nin float t;\nout vec4 c;\nvoid main() { c = vec4(t); }\n"}});
    const EsProgram es = toEs(core, {.draws = {.patchVertices = 2, .haveWideLines = true}});
    EXPECT_EQ(ids(es.diagnostics), "");
    EXPECT_EQ(es.wideLines.captured,
              (std::vector<std::string>{kLevelOutputs[0], kLevelOutputs[1], "gl_Position", "t"}));
    EXPECT_EQ(es.wideLines.components, kLevelComponents + 5);
    TranslatedProgram program;
    program.stages = es.stages;
    EXPECT_EQ(glslangErrors(program), "");
}

}  // namespace
}  // namespace glibra::glsl::test
