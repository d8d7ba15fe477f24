// What the explanations of compile logs add: missing semicolons, words of other languages, types.

#include <gtest/gtest.h>

#include <string>

#include "glsl/emit/log.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// Mesa counts a run of blanks as one column.
int collapsed(const std::string& source, int line, int column) {
    std::size_t at = 0;
    for (int i = 1; i < line; ++i) at = source.find('\n', at) + 1;
    int counted = 1;
    for (int i = 1; i < column; ++i, ++at)
        if (source[at] != ' ' || source[at + 1] != ' ' || i + 1 == column) ++counted;
    return counted;
}

/// The first message for an error that Mesa reports at the user's line and column.
std::string explained(const std::string& source, int line, int column, const std::string& driver) {
    const TranslatedProgram translated = translateSingle(Stage::fragment, source);
    if (translated.stages.empty()) return "not translated";
    const std::string log = "0:" + std::to_string(line) + "(" +
                            std::to_string(collapsed(source, line, column)) + "): error: " + driver + "\n";
    return toString(explainCompileLog(translated, translated.stages.at(0), log).at(0));
}

const std::string kHead = "#version 330 core\nin vec3 vN;\nout vec4 fC;\n";

TEST(MissingSemicolon, IsReportedAtTheEndOfTheLineBefore) {
    EXPECT_EQ(explained(kHead + "void main() {\n    vec3 n = normalize(vN)\n\n    float d = n.z;\n}\n", 7, 5,
                        "syntax error, unexpected BASIC_TYPE_TOK, expecting ',' or ';'"),
              "a.frag:5:27: error: missing ';' after ')' [glsl-E01]");
    EXPECT_EQ(explained(kHead + "void main() {\n    fC = vec4(1.)\n}\n", 6, 1,
                        "syntax error, unexpected '}', expecting ',' or ';'"),
              "a.frag:5:18: error: missing ';' after ')' [glsl-E01]");
    EXPECT_EQ(explained(kHead + "uniform float uA\nuniform float uB;\nvoid main() { fC = vec4(uA + uB); }\n",
                        5, 1, "syntax error, unexpected UNIFORM, expecting ',' or ';'"),
              "a.frag:4:17: error: missing ';' after 'uA' [glsl-E01]");
    EXPECT_EQ(
        explained(kHead + "void main() {\n    float d = 1.\n    if (d > 0.) d = 2.;\n    fC = vec4(d);\n}\n",
                  6, 5, "syntax error, unexpected IF, expecting ',' or ';'"),
        "a.frag:5:17: error: missing ';' after '1.' [glsl-E01]");
}

TEST(SyntaxErrors, NameACharacterThatGlslDoesNotHave) {
    for (const std::string letter : {"\xC3\xA4", "\xE2\x80\xA6"})
        for (const char* driver : {"syntax error, unexpected end of file", "syntax error, unexpected $end"})
            EXPECT_EQ(explained(kHead + "void main(){ float " + letter + " = 1.; }\n", 4, 20, driver),
                      "a.frag:4:20: error: syntax error: GLSL has no character '" + letter +
                          "' outside comments [glsl-E01]");
}

TEST(SyntaxErrors, NeverUseTheCompilersOwnWords) {
    EXPECT_NE(explained(kHead + "void main() {}\n", 9, 1, "syntax error, unexpected \"MAX_LIGHTS\"")
                  .find("MAX_LIGHTS"),
              std::string::npos)
        << "a word of the shader stays";
    // With #line the compiler's line may be that of other text.
    const std::string source = "#version 330\nin vec2 vST;\n#line 1\nvoid main() {}\nfoo\n";
    const std::string found =
        explained(source, 2, 1, "syntax error, unexpected NEW_IDENTIFIER, expecting end of file");
    EXPECT_EQ(found.find("NEW_IDENTIFIER"), std::string::npos) << found;
    EXPECT_NE(found.find("syntax error"), std::string::npos) << found;
}

TEST(MissingSemicolon, IsNotSaidBetweenParentheses) {
    const auto said = [](const std::string& statement, int column) {
        return explained(kHead + "void main() {\n" + statement + "\n}\n", 5, column,
                         "syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ')'");
    };
    EXPECT_EQ(said("fC = mix(vec4(1.) vec4(0.), .5);", 19),
              "a.frag:5:18: error: missing ',' or ')' after ')' [glsl-E01]");
    EXPECT_EQ(said("for (int i = 0 i < 3; ++i) fC = vec4(1.);", 16),
              "a.frag:5:15: error: missing ';' after '0' [glsl-E01]");
    EXPECT_EQ(said("fC = vec4(1.) fC += fC;", 15), "a.frag:5:14: error: missing ';' after ')' [glsl-E01]");
}

TEST(MissingSemicolon, NamesOfTheTranslatorAreTheUsers) {
    EXPECT_EQ(explained("#version 120\nvoid main() {\n    vec4 c = gl_Color\n    gl_FragColor = c;\n}\n", 4,
                        5, "syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ';'"),
              "a.frag:3:22: error: missing ';' after 'gl_Color' [glsl-E01]");
}

TEST(MissingSemicolon, IsFoundWithoutAColumnToo) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment, kHead + "void main() {\n    float d = 1.\n    fC = vec4(d);\n}\n");
    const Diagnostics found = explainCompileLog(
        translated, translated.stages.at(0),
        "0(6) : error C0000: syntax error, unexpected identifier, expecting ',' or ';' at token \"fC\"\n");
    EXPECT_EQ(toString(found.at(0)), "a.frag:5:17: error: missing ';' after '1.' [glsl-E01]");
}

TEST(MissingSemicolon, IsNotInvented) {
    // After the parenthesis of an if, and where an operator stands.
    EXPECT_EQ(explained(kHead + "void main() {\n    if (true) }\n}\n", 5, 15, "syntax error, unexpected '}'"),
              "a.frag:5:15: error: syntax error at '}' [glsl-E01]");
    EXPECT_EQ(explained(kHead + "void main() {\n    fC = vec4(1.) + * 2.;\n}\n", 5, 21,
                        "syntax error, unexpected \'*\'"),
              "a.frag:5:21: error: syntax error at '*' [glsl-E01]");
}

TEST(DialectSlips, GetTheNameThatGlslHas) {
    const auto slip = [](const std::string& call, const std::string& word) {
        return explained(kHead + "void main() {\n    fC = vec4(" + call + ");\n}\n", 5, 15,
                         "no function with name '" + word + "'");
    };
    EXPECT_EQ(slip("frac(vN.x)", "frac"),
              "a.frag:5:15: error: no function with name 'frac'; did you mean 'fract'? [glsl-E01]");
    EXPECT_NE(slip("saturate(vN.x)", "saturate").find("did you mean 'clamp(x, 0.0, 1.0)'?"),
              std::string::npos);
    EXPECT_NE(slip("lerp(0., 1., vN.x)", "lerp").find("did you mean 'mix'?"), std::string::npos);
    EXPECT_NE(slip("texture2DLod(s, vN.xy, 0.)", "texture2DLod").find("did you mean 'textureLod'?"),
              std::string::npos);
    EXPECT_NE(slip("smoothstp(0., 1., vN.x)", "smoothstp").find("did you mean 'smoothstep'?"),
              std::string::npos);
    EXPECT_EQ(slip("quux(vN.x)", "quux").find("did you mean"), std::string::npos);
}

TEST(DialectSlips, NamesOfTheShaderAreSuggestedAsTheUserWroteThem) {
    const std::string source = kHead +
                               "uniform float uShininess;\nvoid main() {\n    float diffuse = uShininess;\n  "
                               "  fC = vec4(difuse);\n}\n";
    EXPECT_EQ(explained(source, 7, 15, "`difuse' undeclared"),
              "a.frag:7:15: error: `difuse' undeclared; did you mean 'diffuse'? [glsl-E01]");
    EXPECT_EQ(
        explained(source, 7, 15, "'uShinines' : undeclared identifier"),
        "a.frag:7:15: error: 'uShinines' : undeclared identifier; did you mean 'uShininess'? [glsl-E01]");
}

TEST(DialectSlips, AnUnknownTypeIsNamed) {
    EXPECT_EQ(explained(kHead + "void main() {\n    float3 q = vN;\n    fC = vec4(q, 1.);\n}\n", 5, 12,
                        "syntax error, unexpected NEW_IDENTIFIER, expecting ',' or ';'"),
              "a.frag:5:5: error: unknown type 'float3'; did you mean 'vec3'? [glsl-E01]");
}

TEST(TypeMismatch, NamesBothTypes) {
    EXPECT_EQ(explained(kHead + "void main() {\n    fC = vec4(1.) + vN;\n}\n", 5, 10,
                        "vector size mismatch for arithmetic operator"),
              "a.frag:5:10: error: vector size mismatch for arithmetic operator: vec4 + vec3 [glsl-E01]");
    EXPECT_EQ(explained(kHead + "void main() {\n    mat3 m = mat3(1.);\n    fC = m * vec4(1.);\n}\n", 6, 10,
                        "size mismatch for matrix multiplication"),
              "a.frag:6:10: error: size mismatch for matrix multiplication: mat3 * vec4 [glsl-E01]");
    EXPECT_EQ(explained(kHead + "float g(vec3 a) {\n    return a;\n}\nvoid main() { fC = vec4(g(vN)); }\n", 5,
                        5, "could not implicitly convert return value to float, in function `g'"),
              "a.frag:5:5: error: could not implicitly convert return value to float, in function `g': the "
              "value is a "
              "vec3, the function returns a float [glsl-E01]");
    EXPECT_EQ(explained(kHead + "void main() {\n    bool e = vec4(1.) == vN;\n}\n", 5, 14,
                        "operands of `==' must have the same type"),
              "a.frag:5:14: error: operands of `==' must have the same type: vec4 == vec3 [glsl-E01]");
}

TEST(TypeMismatch, OfSeveralOnALineTheNearestIsNamed) {
    const std::string source =
        kHead + "void main() {\n    fC = (vec2(1.) + vN).xxxx + (mat2(1.) * vN).xxxx;\n}\n";
    EXPECT_NE(explained(source, 5, 11, "vector size mismatch for arithmetic operator").find("vec2 + vec3"),
              std::string::npos);
    EXPECT_NE(explained(source, 5, 36, "size mismatch for matrix multiplication").find("mat2 * vec3"),
              std::string::npos);
}

TEST(TypeMismatch, ValidOperandsAreNotListed) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        kHead +
            "void main() {\n    mat4 m = 2. * mat4(1.);\n    vec4 v = m * vec4(vN, 1.) / 2.;\n    ivec2 i = "
            "ivec2(1) + 2;\n    fC = (v + 1.) * (i.x == 3 ? 1. : 2.) * float(i.x << 1);\n}\n");
    ASSERT_EQ(translated.stages.size(), 1U);
    EXPECT_TRUE(translated.stages.front().mismatches.empty())
        << translated.stages.front().mismatches.front().text;
}

}  // namespace
}  // namespace glibra::glsl::test
