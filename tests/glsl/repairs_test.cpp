// Mistakes that are repaired (language, 7.10).

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram fragment(const std::string& text) {
    return translateSingle(Stage::fragment, text);
}
std::string user(const TranslatedProgram& translated) {
    return userPart(translated, Stage::fragment);
}

TEST(Repairs, StraySemicolonIsRemoved) {
    const TranslatedProgram translated =
        fragment("out vec4 o;;\nvoid f() { };\nstruct S { float x; };\n;\nvoid main() { o = vec4(1.); };\n");
    EXPECT_EQ("glsl-W09 glsl-W09 glsl-W09 glsl-W09", ids(translated.diagnostics));
    EXPECT_EQ("stray ';' removed", translated.diagnostics[0].text);
    EXPECT_TRUE(hasTokens(user(translated), "struct S { float x; };"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, BackslashAfterACommentIsRemoved) {
    const TranslatedProgram translated =
        fragment("// c:\\path\\\nout vec4 o;\nvoid main() { o = vec4(1.); } // end \\\n");
    EXPECT_EQ("glsl-W08 glsl-W08", ids(translated.diagnostics));
    EXPECT_EQ(2, translated.diagnostics[0].place.line);
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, FalseConstantLosesItsConst) {
    const TranslatedProgram translated = fragment(
        "#version 330\nuniform vec3 uLight; in vec3 vP;\nconst vec3 eyeLight = normalize(uLight);\nconst "
        "float a = eyeLight.x, b = 2.;\nconst vec3 c = vP;\nconst float d = sqrt(2.) * 3.;\nout vec4 o; void "
        "main() { o = vec4(eyeLight + c, a + b + d); }");
    EXPECT_EQ("'eyeLight' depends on a uniform, 'const' dropped", textOf(translated.diagnostics, "glsl-W10"));
    EXPECT_TRUE(
        hasTokens(user(translated), "vec3 eyeLight = normalize(uLight); float a = eyeLight.x, b = 2.;"));
    EXPECT_TRUE(hasTokens(user(translated), "const float d = sqrt(2.) * 3.;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, ConstFromASuppliedMatrixIsFalseToo) {
    const TranslatedProgram translated =
        fragment("const mat4 m = gl_ModelViewMatrix; out vec4 o; void main() { o = m[0]; }");
    EXPECT_EQ("glsl-W10", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, VariableFromAUniformIsAccepted) {
    const TranslatedProgram translated =
        fragment("uniform float u; float twice = 2. * u; out vec4 o; void main() { o = vec4(twice); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, ConstInsideAnInitialiserIsRemoved) {
    const TranslatedProgram translated = fragment(
        "const vec3 a = const vec3(1.);\nfloat b[2] = const float[2](1., 2.);\nout vec4 o; void main() { "
        "const float c = const 2.; o = vec4(a, b[0] + c) * vec4(const vec2(1.), 1., 1.); }");
    EXPECT_EQ("glsl-W20 glsl-W20 glsl-W20 glsl-W20", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, HonestConstStays) {
    const TranslatedProgram translated = fragment(
        "const vec3 a = vec3(1.); const float[2] b = float[2](1., 2.);\nfloat f(const float x, const in vec3 "
        "y) { const int i = 3; return x * float(i); }\nout vec4 o; void main() { for (const int k = 0; k < "
        "0;) { } o = vec4(a, f(b[0], a)); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, RepeatedUniformIsRemoved) {
    const TranslatedProgram translated = fragment(
        "#version 330\nuniform float uKa;\nuniform float uKd, uKa;\nout vec4 o; void main() { o = vec4(uKa + "
        "uKd); }");
    EXPECT_EQ("uniform 'uKa' declared again on line 3, ignored", textOf(translated.diagnostics, "glsl-W21"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, UniformRepeatedWithAnotherTypeIsTheUsersError) {
    EXPECT_EQ("",
              ids(fragment("uniform float uKa; uniform vec2 uKa; out vec4 o; void main() { o = vec4(1.); }")
                      .diagnostics));
}

TEST(Repairs, UniformInTheOtherBranchIsNotRepeated) {
    const TranslatedProgram translated = fragment(
        "#define FANCY\n#ifdef FANCY\nuniform float uA;\n#else\nuniform float uA;\n#endif\nout vec4 o; void "
        "main() { o = vec4(uA); }");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, WrittenInputGetsACopy) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 330\nout vec2 vST, vX; void main() { vST = vX = vec2(1.); gl_Position = aVertex; }\n"},
         {Stage::fragment,
          "#version 330\nin vec2 vST, vX;\nstruct S { vec2 vST; };\nout vec4 o; void main() { S s; s.vST = "
          "vX; vST *= 2.; o = vec4(vST, s.vST); }\n"}});
    EXPECT_EQ("input 'vST' is written to; a local copy is used", textOf(translated.diagnostics, "glsl-W22"));
    EXPECT_TRUE(hasTokens(user(translated), "in vec2 vST; vec2 glibra_vST = vST; in vec2 vX;"));
    EXPECT_TRUE(hasTokens(user(translated), "s.vST = vX; glibra_vST *= 2.;"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, LocalOfTheSameNameIsNoWriteToTheInput) {
    EXPECT_EQ(
        "", ids(translateStages(
                    {{Stage::vertex,
                      "#version 330\nout vec2 vST; void main() { vST = vec2(1.); gl_Position = aVertex; }\n"},
                     {Stage::fragment,
                      "#version 330\nin vec2 vST; out vec4 o; void f(vec2 vST) { vST *= 2.; } void main() { "
                      "o = vec4(vST, vST); { vec2 vST = vec2(0.); vST = vec2(1.); } }\n"}})
                    .diagnostics));
}

TEST(Repairs, OddBytesAndLineEndsAreAccepted) {
    const TranslatedProgram translated = translate(program(
        {{Stage::fragment, "\xEF\xBB\xBF#version 330\r\nout vec4 o;\rvoid main() { o = vec4(1.); }"}}));
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Repairs, JoinedLinesKeepTheNumbers) {
    const TranslatedProgram translated = fragment(
        "#version 330\n#define SUM(a, b) \\\n  ((a) + \\\n  (b))\nout vec4 o; void main() { float lo\\\nng = "
        "1.; \\\n o = vec4(SUM(lo\\\nng, 2.)); }\nint line = __LINE__;\n");
    EXPECT_EQ("", glslangErrors(translated));
    EXPECT_EQ(std::string::npos, user(translated).find('\\'));
    const std::string text = user(translated);
    const std::size_t at = text.find("int line");
    EXPECT_EQ(8, std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

struct Widening {
    const char* call;
    const char* emitted;     ///< null: the text stays as it is
    bool isReported = true;  ///< false: GLSL itself converts here
};

TEST(Widening, ScalarsBecomeVectorsWhereNoOverloadTakesThem) {
    const Widening cases[] = {
        {"pow(v3, 2.)", "pow(v3, vec3(2.))"},
        {"pow(2., v3)", "pow(vec3(2.), v3)"},
        {"pow(v3.xy, s)", "pow(v3.xy, vec2(s))"},
        {"pow(v3 * 2. + s, 1. / s)", "pow(v3 * 2. + s, vec3(1. / s))"},
        {"mod(s, v3)", "mod(vec3(s), v3)"},
        {"min(s, v3)", "min(vec3(s), v3)"},
        {"max(0., v3)", "max(vec3(0.), v3)"},
        {"step(v3, s)", "step(v3, vec3(s))"},
        {"smoothstep(0., v3, v3)", "smoothstep(vec3(0.), v3, v3)"},
        {"smoothstep(v3, v3, s)", "smoothstep(v3, v3, vec3(s))"},
        {"clamp(v3, 0., v3)", "clamp(v3, vec3(0.), v3)"},
        {"clamp(s, v3, v3)", "clamp(vec3(s), v3, v3)"},
        {"mix(v3, 1., s)", "mix(v3, vec3(1.), vec3(s))"},
        {"mix(0., 1., v3)", "mix(vec3(0.), vec3(1.), v3)"},
        {"max(pow(v3, s), 0.)", "max(pow(v3, vec3(s)), 0.)"},
        {"pow(pow(v3, 2.), 3)", "pow(pow(v3, vec3(2.)), vec3(3))"},
        {"pow(f(s), 2.)", "pow(f(s), vec3(2.))"},
        {"pow(normalize(v3), length(v3))", "pow(normalize(v3), vec3(length(v3)))"},
        {"pow(m * v3, 2.)", "pow(m * v3, vec3(2.))"},
        {"pow(texture(t, v3.xy).rgb, 2.2)", "pow(texture(t, v3.xy).rgb, vec3(2.2))"},
        {"pow(S(v3).c, 2.)", "pow(S(v3).c, vec3(2.))"},
        {"pow(list[1], 2.)", "pow(list[1], vec3(2.))"},
        {"pow(POW2(v3), s)", "pow(((v3) * (v3)), vec3(s))"},
        {"mod(v3, 2.)", nullptr},
        {"min(v3, 0.)", nullptr},
        {"max(v3, 0)", "max(v3, float(0))", false},
        {"clamp(v3, 0., 1.)", nullptr},
        {"mix(v3, v3, s)", nullptr},
        {"step(0.5, v3)", nullptr},
        {"smoothstep(0., 1., v3)", nullptr},
        {"pow(v3, v3)", nullptr},
        {"pow(s, 2.) * v3", nullptr},
        {"min(3, 4) * v3", nullptr},
    };
    for (const Widening& each : cases) {
        const bool two = std::string_view(each.call).find(".xy, s") != std::string_view::npos;
        const TranslatedProgram translated = fragment(
            "#define POW2(x) ((x) * (x))\nuniform vec3 v3; uniform float s; uniform mat3 m; uniform "
            "sampler2D t; uniform vec3 list[2]; struct S { vec3 c; };\nvec3 f(float x) { return vec3(x); "
            "}\nout vec4 o;\nvoid main() { vec3 q; q.xy" +
            std::string(two ? "" : "z") + " = " + each.call + "; o.xyz = q; }\n");
        EXPECT_EQ(each.emitted != nullptr && each.isReported, has(translated.diagnostics, "glsl-W23"))
            << each.call;
        EXPECT_TRUE(hasTokens(user(translated), each.emitted ? each.emitted : each.call)) << user(translated);
        EXPECT_EQ("", glslangErrors(translated)) << each.call;
    }
}

TEST(Widening, MessageSaysTheShape) {
    EXPECT_EQ("pow(vec2, float): the scalar is widened to vec2",
              textOf(fragment("out vec4 o; void main() { vec2 a = vec2(1.); o = vec4(pow(a, .5), 0., 1.); }")
                         .diagnostics,
                     "glsl-W23"));
}

TEST(Widening, WhatIsNotCertainIsLeftAlone) {
    for (const char* call :
         {"pow(unknown(1.), 2.)", "pow(v3, vec2(1.))", "max(dvec3(1.), v3.x)", "min(ivec3(1), 2.)"})
        EXPECT_FALSE(has(fragment("#version 400\nuniform vec3 v3; out vec4 o; void main() { o.xyz = " +
                                  std::string(call) + "; }")
                             .diagnostics,
                         "glsl-W23"))
            << call;
}

TEST(Widening, UsersOwnFunctionIsLeftAlone) {
    EXPECT_EQ("", ids(fragment("vec3 pow(vec3 a, float b) { return a * b; } out vec4 o; void main() { o.xyz "
                               "= pow(vec3(1.), 2.); }")
                          .diagnostics));
}

TEST(Widening, EachUseOfAMacroIsWidenedAsItNeeds) {
    const TranslatedProgram agree = fragment(
        "#define GAMMA(c) pow(c, 2.2)\nout vec4 o; void main() { vec3 a = vec3(.5); o = vec4(GAMMA(a) + "
        "GAMMA(a.zyx), 1.); }");
    EXPECT_TRUE(hasTokens(user(agree), "pow(a, vec3(2.2)) + pow(a.zyx, vec3(2.2))"));
    EXPECT_EQ("", glslangErrors(agree));
    const TranslatedProgram differ = fragment(
        "#define GAMMA(c) pow(c, 2.2)\nout vec4 o; void main() { vec3 a = vec3(.5); o = vec4(GAMMA(a), "
        "GAMMA(a.x)); }");
    EXPECT_TRUE(hasTokens(user(differ), "o = vec4(pow(a, vec3(2.2)), pow(a.x, 2.2));"));
    EXPECT_EQ("", glslangErrors(differ));
}

TEST(Widening, ObjectMacroArgumentIsWrappedAtItsUse) {
    const TranslatedProgram translated = fragment(
        "#define SHININESS 1. + 7.\nout vec4 o; void main() { vec3 a = vec3(.5); o = vec4(pow(a, SHININESS), "
        "SHININESS); }");
    EXPECT_TRUE(hasTokens(user(translated), "pow(a, vec3(1. + 7.)), 1. + 7."));
    EXPECT_EQ("", glslangErrors(translated));
}

}  // namespace
}  // namespace glibra::glsl::test
