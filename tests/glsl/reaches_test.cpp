// What stages reach: vertices of patches, emitted vertices, axes of invocations, elements of buffers; and
// what they read before it has a value.

#include <gtest/gtest.h>

#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram patches(const std::string& control, int vertices = 4) {
    return translateStages(
        {{Stage::vertex,
          "#version 410\nout vec3 vColor;\nvoid main() { vColor = vec3(1.); gl_Position = vec4(0.); }\n"},
         {Stage::tessControl, "#version 410\nlayout(vertices = " + std::to_string(vertices) +
                                  ") out;\nin vec3 vColor[];\nvoid main() {\n" + control + "\n}\n"},
         {Stage::tessEvaluation,
          "#version 410\nlayout(quads) in;\nvoid main() { gl_Position = vec4(0.); }\n"},
         {Stage::fragment, kPlainFragment}});
}

TEST(Patches, AreReadUpToTheGreatestSubscript) {
    const std::string own = "gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;";
    EXPECT_EQ(patches(own).patchVerticesRead, 4);
    EXPECT_EQ(patches(own, 3).patchVerticesRead, 3);
    EXPECT_EQ(patches("gl_out[gl_InvocationID].gl_Position = gl_in[5].gl_Position;").patchVerticesRead, 6);
    EXPECT_EQ(patches("gl_out[gl_InvocationID].gl_Position = vec4(vColor[2], 1.);").patchVerticesRead, 3);
    EXPECT_EQ(patches("if (gl_InvocationID == 0) gl_TessLevelInner[0] = 2.;\n" + own).patchVerticesRead, 4)
        << "picks an invocation, but limits nothing";
    EXPECT_EQ(patches("if (gl_InvocationID < 3) " + own).patchVerticesRead, 0);
    EXPECT_EQ(patches("if (gl_InvocationID < gl_PatchVerticesIn) " + own).patchVerticesRead, 0);
    EXPECT_EQ(patches("gl_out[gl_InvocationID].gl_Position = gl_in[0].gl_Position;").patchVerticesRead, 1);
}

/// The vertices that a geometry stage surely emits.
double mostEmitted(const std::string& body, const std::string& functions = "") {
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kPlainVertex},
                         {Stage::geometry,
                          "#version 330\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 4) "
                          "out;\nuniform int uN;\n" +
                              functions + "void main() {\n" + body + "\n}\n"},
                         {Stage::fragment, kPlainFragment}});
    EXPECT_EQ(translated.maxVertices, 4);
    EXPECT_EQ(translated.maxVerticesPlace.line, 3);
    const TranslatedStage& stage = translated.stages.at(1);
    double all = stage.emits;
    for (const CountedLoop& each : stage.loops)
        all += emittedBy(
            each, [](std::string_view name) { return name == "uN" ? std::optional(10.) : std::nullopt; });
    return all;
}

TEST(Emission, CountsWhatIsSure) {
    EXPECT_EQ(mostEmitted("EmitVertex(); EmitVertex(); EndPrimitive();"), 2);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < 5; ++i) { gl_Position = vec4(i); EmitVertex(); }"), 5);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < 3; ++i) for (int k = 0; k <= 1; ++k) EmitVertex();"), 6);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < uN; ++i) EmitVertex();"), 10);
    EXPECT_EQ(mostEmitted("corner(); corner(); EmitVertex();", "void corner() { EmitVertex(); }\n"), 3);
    EXPECT_EQ(mostEmitted("EmitVertex(); int i = 0; do { EmitVertex(); i++; } while (i < 4);"), 5);
    EXPECT_EQ(mostEmitted("float x = uN > 1 ? 1. : 2.; gl_Position = vec4(x); EmitVertex();"), 1);
}
TEST(Emission, LeavesOutWhatDepends) {
    EXPECT_EQ(mostEmitted("if (uN > 3) { EmitVertex(); } else EmitVertex(); EmitVertex();"), 1);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < 9; ++i) { if (i > uN) break; EmitVertex(); }"), 0);
    EXPECT_EQ(mostEmitted("if (uN > 1) for (int i = 0; i < 9; ++i) EmitVertex();"), 0);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < 9; ++i) { if (i == 2) EmitVertex(); EmitVertex(); }"), 9);
    EXPECT_EQ(mostEmitted("for (int i = 0; i < int(gl_in[0].gl_Position.x); ++i) for (int k = 0; k < 9; ++k) "
                          "EmitVertex();"),
              0);
}

TranslatedProgram compute(const std::string& body) {
    return translateSingle(Stage::compute,
                           "#version 430\nlayout(local_size_x = 4) in;\nlayout(std430) buffer Data { uint "
                           "count; float data[]; };\nlayout(std430) buffer More { float all[]; } more;\nvoid "
                           "main() {\n" +
                               body + "\n}\n");
}

std::string subscripts(const std::string& body) {
    std::string found;
    const TranslatedProgram translated = compute(body);
    for (const ElementSubscript& each : translated.stages.at(0).subscripts)
        found += (found.empty() ? "" : " ") + each.array + ":" +
                 (each.number.empty() ? std::to_string(each.constant) : each.number);
    return found;
}

TEST(Subscripts, AreNumbersOfInvocationsAndConstants) {
    EXPECT_EQ(subscripts("data[gl_GlobalInvocationID.x] = 1.;"), "data:gl_GlobalInvocationID.x");
    EXPECT_EQ(subscripts("uint i = gl_GlobalInvocationID.x; data[i] = more.all[i];"),
              "data:gl_GlobalInvocationID.x all:gl_GlobalInvocationID.x");
    EXPECT_EQ(subscripts("int i = int(gl_GlobalInvocationID.x); data[i] = more.all[7];"),
              "data:gl_GlobalInvocationID.x all:7");
    EXPECT_EQ(subscripts("data[gl_LocalInvocationIndex] = 1.;"), "data:gl_LocalInvocationIndex");
}
TEST(Subscripts, ThatAreLimitedAreNotKnown) {
    EXPECT_EQ(subscripts("uint i = gl_GlobalInvocationID.x; if (i >= count) return; data[i] = 1.;"), "");
    EXPECT_EQ(subscripts("uint i = gl_GlobalInvocationID.x; if (i < data.length()) data[i] = 1.;"), "");
    EXPECT_EQ(subscripts("if (gl_GlobalInvocationID.x > 5u) return; data[gl_GlobalInvocationID.x] = 1.;"),
              "");
    EXPECT_EQ(subscripts("uint i = gl_GlobalInvocationID.x; i = min(i, 3u); data[i] = 1.;"), "");
    EXPECT_EQ(subscripts("data[gl_GlobalInvocationID.x % 4u] = 1.;"), "");
    EXPECT_EQ(subscripts("data[gl_GlobalInvocationID.x + 1u] = 1.;"), "");
}

TEST(InvocationAxes, AreThoseOfTheComponentsThatAreRead) {
    using Axes = std::array<bool, 3>;
    EXPECT_EQ(compute("data[gl_GlobalInvocationID.x] = 1.;").invocationAxes, (Axes{true, false, false}));
    EXPECT_EQ(compute("ivec2 p = ivec2(gl_GlobalInvocationID.xy);").invocationAxes,
              (Axes{true, true, false}));
    EXPECT_EQ(compute("uint z = gl_WorkGroupID.z;").invocationAxes, (Axes{false, false, true}));
    EXPECT_EQ(compute("uvec3 p = gl_GlobalInvocationID;").invocationAxes, (Axes{true, true, true}));
    EXPECT_EQ(compute("uint l = gl_LocalInvocationID.y;").invocationAxes, (Axes{}));
}

/// The names of glsl-W28, with the lines of the body.
std::string unassigned(const std::string& body, const std::string& functions = "") {
    std::string found;
    for (const Diagnostic& each :
         translateSingle(Stage::fragment, functions + "out vec4 fColor;\nvoid main() {\n" + body + "\n}\n")
             .diagnostics)
        if (each.id == "glsl-W28") found += each.text.substr(0, each.text.find(" is"));
    return found;
}

TEST(FirstReads, AreReported) {
    EXPECT_EQ(unassigned("float a; fColor = vec4(a);"), "'a'");
    EXPECT_EQ(unassigned("vec3 a, b; b = vec3(1.); fColor = vec4(a + b, 1.);"), "'a'");
    EXPECT_EQ(unassigned("float sum; for (int i = 0; i < 4; ++i) sum += float(i); fColor = vec4(sum);"),
              "'sum'");
    EXPECT_EQ(unassigned("int n; n++; fColor = vec4(n);"), "'n'");
    EXPECT_EQ(unassigned("float a; float b = sin(a); fColor = vec4(b);"), "'a'");
}
TEST(FirstReads, AreNoAssignments) {
    EXPECT_EQ(unassigned("float a; a = 1.; fColor = vec4(a);"), "");
    EXPECT_EQ(unassigned("vec4 a; a.x = 1.; a.yzw = vec3(0.); fColor = a;"), "");
    EXPECT_EQ(unassigned("float a; if (gl_FragCoord.x > 1.) a = 1.; else a = 2.; fColor = vec4(a);"), "");
    EXPECT_EQ(unassigned("float a[3]; a[0] = 1.; fColor = vec4(a[0]);"), "");
    EXPECT_EQ(unassigned("float whole; float rest = modf(gl_FragCoord.x, whole); fColor = vec4(rest);"), "");
    EXPECT_EQ(unassigned("float a; set(a); fColor = vec4(a);", "void set(out float x) { x = 1.; }\n"), "");
    EXPECT_EQ(unassigned("{ float a; a = 1.; } float a = 3.; fColor = vec4(a);"), "");
    EXPECT_EQ(unassigned("int i; for (i = 0; i < 3; ++i) {} fColor = vec4(i);"), "");
    EXPECT_EQ(unassigned("mat2 m; m[0] = vec2(1.); m[1] = vec2(0.); fColor = vec4(m[0], m[1]);"), "");
}

TEST(FirstReads, FollowThePathsOfTheProgram) {
    // After branches, jumps and loops
    EXPECT_EQ(
        unassigned("float a; if (gl_FragCoord.x > 1.) { fColor = vec4(0.); return; } fColor = vec4(a);"),
        "'a'");
    EXPECT_EQ(unassigned("float a; for (int i = 0; i < 3; ++i) { if (i > 0) fColor = vec4(a); a = 1.; }"),
              "");
    EXPECT_EQ(unassigned("float a; for (int i = 0; i < 3; ++i) { fColor = vec4(a); a = 1.; }"), "'a'");
    // A loop that may have no round reads what a later round of an outer one has written.
    EXPECT_EQ(unassigned("float a[4]; int n = 0; for (int i = 0; i < 4; ++i) { int at = n++; "
                         "for (; at > 0 && gl_FragCoord.x > 1.; --at) a[at] = a[at - 1]; a[at] = 1.; }"),
              "");
    EXPECT_EQ(
        unassigned(
            "float a; for (int i = 0; i < 3; ++i) { while (gl_FragCoord.x > float(i)) fColor = vec4(a); "
            "a = 1.; }"),
        "");
    EXPECT_EQ(unassigned("float a; for (int i = 0; i < 3; ++i) for (int k = 0; k < 3; ++k) a += float(k);"),
              "'a'");
    EXPECT_EQ(unassigned("float a; while (gl_FragCoord.x > 1.) a += 1.; fColor = vec4(a);"), "'a'");
    EXPECT_EQ(unassigned("vec4 c; c.xyz = vec3(1.); fColor = c;"), "'c.w'");
    EXPECT_EQ(unassigned("S s; s.a = 1.; fColor = vec4(s.b);", "struct S { float a, b; };\n"), "'s.b'");
    EXPECT_EQ(unassigned("float a[4]; fColor = vec4(a[2]);"), "'a'");
}

/// The body of main as emitted, after it is known to compile.
std::string initialised(const std::string& body, const std::string& declarations = "") {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment, "out vec4 fColor;\n" + declarations + "void main() {\n" + body + "\n}\n");
    EXPECT_EQ("", glslangErrors(translated)) << body;
    return userPart(translated, Stage::fragment);
}

TEST(InitialValues, AreGivenWhereNoAssignmentIsSure) {
    const std::pair<const char*, const char*> kCases[] = {
        {"float a; if (gl_FragCoord.x > 1.) a = 1.; fColor = vec4(a);", "float a = 0.;"},
        {"float a; while (gl_FragCoord.x < a) a = 1.; fColor = vec4(a);", "float a = 0.;"},
        {"int n; switch (int(gl_FragCoord.x)) { case 0: n = 1; break; } fColor = vec4(n);", "int n = 0;"},
        {"vec4 c; c.rgb = vec3(1.); fColor = c;", "vec4 c = vec4(0.);"},
        {"float a[3]; a[1] = 1.; fColor = vec4(a[int(gl_FragCoord.x)]);",
         "float a[3] = float[3](0., 0., 0.);"},
        {"if (gl_FragCoord.x > 1.) fColor = vec4(1.);", "fColor = vec4(0.);"},
        {"bool b = gl_FragCoord.x > 1. && gl_FragCoord.y > 1.; float a; if (b) a = 1.; fColor = vec4(a);",
         "float a = 0.;"},
    };
    for (const auto& [body, emitted] : kCases) EXPECT_TRUE(hasTokens(initialised(body), emitted)) << body;
    const std::string all = initialised("float a; f(a); fColor = vec4(a + g + h(a));",
                                        "float g;\nvoid f(out float x) { if (gl_FragCoord.x > 1.) x = 1.; }\n"
                                        "float h(float x) { if (x > 1.) return 2.; }\n");
    EXPECT_TRUE(hasTokens(all, "float g = 0.;")) << all;
    EXPECT_TRUE(hasTokens(all, "{ x = 0.; if")) << all;
    EXPECT_TRUE(hasTokens(all, "return 0.; }")) << all;
    EXPECT_TRUE(hasTokens(all, "float a; f(a);")) << all;
}

TEST(InitialValues, AreNotGivenWhereOneIs) {
    for (const char* body :
         {"float a; if (gl_FragCoord.x > 1.) a = 1.; else a = 2.; fColor = vec4(a);",
          "float a; do { a = 1.; } while (gl_FragCoord.x > a); fColor = vec4(a);",
          "int a; switch (int(gl_FragCoord.x)) { case 0: a = 1; break; default: a = 2; } fColor = vec4(a);",
          "float a; if (gl_FragCoord.x > 1.) discard; else a = 1.; fColor = vec4(a);",
          "vec4 a; a.x = 1.; a.yz = vec2(0.); a[3] = 1.; fColor = a;",
          "float a[3]; for (int i = 0; i < 3; ++i) a[i] = 1.; fColor = vec4(a[1]);",
          "mat2 a; a[0] = vec2(1.); a[1] = vec2(0.); fColor = vec4(a[0], a[1]);"}) {
        const std::string text = initialised(body);
        EXPECT_FALSE(hasTokens(text, "a = ") && text.find("a = 0") != std::string::npos) << text;
        EXPECT_EQ(text.find("(0., 0."), std::string::npos) << text;
        EXPECT_EQ(text.find("fColor = vec4(0.)"), std::string::npos) << text;
    }
}

TEST(Overloads, AreChosenByTheRulesOfGlsl) {
    const auto call = [](const std::string& functions, const std::string& value) {
        return translateSingle(Stage::fragment,
                               "#version 450\nuniform int n; uniform uint m;\nout vec4 o;\n" + functions +
                                   "void main() { o = vec4(" + value + "); }\n");
    };
    const std::string two = "float f(float x) { return x; }\nfloat f(double x) { return 2.; }\n";
    EXPECT_TRUE(hasTokens(userPart(call(two, "f(n)"), Stage::fragment), "f(float(n))"));
    const std::string mixed = "float f(float x) { return x; }\nfloat f(uint x) { return 2.; }\n";
    EXPECT_TRUE(has(call(mixed, "f(n)").diagnostics, "glsl-E17"));
    EXPECT_TRUE(hasTokens(userPart(call(mixed, "f(m)"), Stage::fragment), "f(m)"));
    EXPECT_EQ("", glslangErrors(call(two, "f(n)")));
}

TEST(FirstLine, IsThatOfTheTextAfterBlankLines) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment, "\n\n\n\n#version 330\nout vec4 c;\nvoid main() { c = gl_Color; }\n");
    EXPECT_EQ(translated.stages.at(0).firstLine, 5);
}

}  // namespace
}  // namespace glibra::glsl::test
