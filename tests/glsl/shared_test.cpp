// Subscripts of shared variables stay within their sizes.

#include <gtest/gtest.h>

#include "glsl/emit/log.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram translateCompute(const std::string& declarations, const std::string& statements) {
    return translateStages(
        {{Stage::compute, "#version 450\nlayout(local_size_x = 64) in;\n" + declarations +
                              "\nvoid main() {\nint i = int(gl_LocalInvocationID.x); uint u = "
                              "gl_LocalInvocationIndex;\n" +
                              statements + "\n}\n"}});
}

/// The statements as emitted, after they are known to compile.
std::string emitted(const std::string& declarations, const std::string& statements) {
    const TranslatedProgram translated = translateCompute(declarations, statements);
    EXPECT_EQ("", ids(translated.diagnostics)) << statements;
    EXPECT_EQ("", glslangErrors(translated)) << statements;
    const std::string text = userPart(translated, Stage::compute);
    const std::size_t start = text.find("gl_LocalInvocationIndex;\n") + 25;
    return text.substr(start, text.rfind("\n}") - start);
}

TEST(SharedArrays, SubscriptsAreLimited) {
    const std::string part = "const int N = 64;\nshared float part[N];";
    EXPECT_EQ("part[glibra_within(i + 1, part.length())] = 2.;", emitted(part, "part[i + 1] = 2.;"));
    EXPECT_EQ("part[glibra_within(u, part.length())] += part[glibra_within(u + 32u, part.length())];",
              emitted(part, "part[u] += part[u + 32u];"));
    EXPECT_EQ("float f = part[glibra_within(int(part[glibra_within(i, part.length())]), part.length())];",
              emitted(part, "float f = part[int(part[i])];"));
    EXPECT_EQ("part[glibra_within(i++, part.length())]++;", emitted(part, "part[i++]++;"));
    EXPECT_EQ("part[glibra_within((i++, i), part.length())] = 1.;", emitted(part, "part[i++, i] = 1.;"));
    EXPECT_EQ("(part)[glibra_within(i, part.length())] = 1.;", emitted(part, "(part)[i] = 1.;"));
}

TEST(SharedArrays, ConstantSubscriptsStay) {
    const std::string part = "const int N = 64;\nshared float part[N];";
    EXPECT_EQ("part[63] = part[N - 1] + part[0x1F] + part[(N >> 1) - 1];",
              emitted(part, "part[63] = part[N - 1] + part[0x1F] + part[(N >> 1) - 1];"));
    EXPECT_EQ("i = part.length();", emitted(part, "i = part.length();"));
    const TranslatedProgram wrong = translateCompute(part, "part[64] = 1.;");
    EXPECT_TRUE(hasTokens(userPart(wrong, Stage::compute), "part[64] = 1.;"));
    EXPECT_NE(std::string::npos, glslangErrors(wrong).find("out of range"));
}

TEST(SharedArrays, SeveralDimensionsMembersAndVectors) {
    EXPECT_EQ("t[glibra_within(i, t.length())][glibra_within(i + 1, t[0].length())].xy = vec2(0.);",
              emitted("shared vec4 t[8][10];", "t[i][i + 1].xy = vec2(0.);"));
    EXPECT_EQ("t[3][glibra_within(u, t[0].length())].x = 0.;",
              emitted("shared vec4[8][10] t;", "t[3][u].x = 0.;"));
    EXPECT_EQ(
        "s[glibra_within(i, s.length())].m[glibra_within(u, s[0].m.length())].v[glibra_within(i, "
        "s[0].m[0].v.length())] = 1.;",
        emitted("struct M { vec3 v; };\nstruct S { float f; M m[4]; };\nshared S s[16];",
                "s[i].m[u].v[i] = 1.;"));
    EXPECT_EQ("one.m[glibra_within(i, one.m.length())] = 1.;",
              emitted("struct S { float m[4]; };\nshared S one;", "one.m[i] = 1.;"));
    EXPECT_EQ("basis[glibra_within(i, basis.length())] = vec4(1.);",
              emitted("shared mat4 basis;", "basis[i] = vec4(1.);"));
    EXPECT_EQ("uint n = atomicAdd(counts[glibra_within(i, counts.length())], 1u);",
              emitted("shared uint counts[256];", "uint n = atomicAdd(counts[i], 1u);"));
}

TEST(SharedArrays, OtherArraysStay) {
    EXPECT_EQ("float part[4]; part[i] = 1.;",
              emitted("shared float part[64];", "float part[4]; part[i] = 1.;"));
    EXPECT_EQ("all[i] = own[i];",
              emitted("layout(std430) buffer B { float all[]; };\nfloat own[2] = float[2](1., 2.);",
                      "all[i] = own[i];"));
}

TEST(SharedArrays, InMacros) {
    const std::string part = "shared float part[64];\nshared float other[8];\nfloat own[4];";
    const auto of = [&](const std::string& macro, const std::string& statement) {
        const TranslatedProgram translated = translateCompute(part + "\n" + macro, statement);
        EXPECT_EQ("", ids(translated.diagnostics));
        EXPECT_EQ("", glslangErrors(translated)) << statement;
        return userPart(translated, Stage::compute);
    };
    EXPECT_TRUE(
        hasTokens(of("#define AT(k) part[(k)]", "AT(i) = AT(u);"),
                  "part[glibra_within((i), part.length())] = part[glibra_within((u), part.length())];"));
    // One macro for arrays of different sizes, one of which is not shared.
    EXPECT_TRUE(hasTokens(of("#define OF(a, k) a[k]", "OF(part, i) = OF(other, u); OF(own, i) = 1.;"),
                          "part[glibra_within(i, part.length())] = other[glibra_within(u, other.length())]; "
                          "own[i] = 1.;"));
    EXPECT_TRUE(hasTokens(of("#define P part", "P[i] = 1.;"), "part[glibra_within(i, part.length())] = 1.;"));
    EXPECT_TRUE(
        hasTokens(of("#define HERE part[i]", "HERE = HERE + 1.;"),
                  "part[glibra_within(i, part.length())] = part[glibra_within(i, part.length())] + 1.;"));
    EXPECT_TRUE(hasTokens(of("#define SAME(x) x", "SAME(part[i]) = 1.;"),
                          "part[glibra_within(i, part.length())] = 1.;"));
    EXPECT_TRUE(hasTokens(of("#define INDEX(k) [k]", "part INDEX(i) = 1.;"),
                          "part[glibra_within(i, part.length())] = 1.;"));
}

TEST(SharedArrays, RenamedArray) {
    const TranslatedProgram translated =
        translateCompute("shared float texture[64];", "texture[i] = texture[2];");
    EXPECT_EQ("glsl-W05", ids(translated.diagnostics));
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::compute),
                          "glibra_texture[glibra_within(i, glibra_texture.length())] = glibra_texture[2];"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(SharedArrays, MessagesHaveTheUsersColumns) {
    const TranslatedProgram translated =
        translateCompute("shared float part[64];", "part[i] = part[u] + wrong;");
    const std::string text = userPart(translated, Stage::compute);
    const std::size_t start = text.find("part[glibra");
    const std::size_t column = text.find("wrong") - start + 1;
    const std::string log = "0:6(" + std::to_string(column) + "): error: `wrong' undeclared\n";
    const Diagnostics found = explainCompileLog(translated, translated.stages.at(0), log);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ((Place{"a.comp", 6, 21}), found[0].place);
    const Diagnostics type =
        explainCompileLog(translated, translated.stages.at(0),
                          "0:6(6): error: no matching function for call to `glibra_within(float, int)'\n");
    ASSERT_FALSE(type.empty());
    EXPECT_EQ(std::string::npos, type[0].text.find("glibra_")) << type[0].text;
}

}  // namespace
}  // namespace glibra::glsl::test
