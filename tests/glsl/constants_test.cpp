// Constants that the scene gives: macros, and the values of #define and const (language, 12.1).

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support.h"

namespace glibra::glsl::test {
namespace {

TranslatedProgram translatedWith(std::vector<Constant> constants, Stages stages) {
    ProgramRequest request = program(std::move(stages));
    for (std::size_t i = 0; i < constants.size(); ++i)
        request.constantPlaces.push_back({"a.glib", static_cast<int>(i) + 5, 20});
    request.constants = std::move(constants);
    return translate(request);
}

TranslatedProgram fragmentWith(std::vector<Constant> constants, const std::string& body) {
    return translatedWith(std::move(constants),
                          {{Stage::vertex, kPlainVertex}, {Stage::fragment, "#version 330\n" + body}});
}

Constant number(const std::string& name, double value, const std::string& type = {}) {
    return {name, type, false, {value}};
}

constexpr const char* kMain = "out vec4 c;\nvoid main() { c = vec4(float(N)); }\n";

TEST(Constants, AreWrittenForTheirType) {
    const auto text = [](double value, std::string_view type) {
        return glsl::textOf(number("N", value), type).value_or("none");
    };
    EXPECT_EQ(text(4, ""), "4");
    EXPECT_EQ(text(-4, ""), "(-4)");
    EXPECT_EQ(text(.1, ""), "0.1");
    EXPECT_EQ(text(4, "float"), "4.0");
    EXPECT_EQ(text(-.5, "float"), "(-0.5)");
    EXPECT_EQ(text(1e-7, "float"), "1e-07");
    EXPECT_EQ(text(1e39, "float"), "none");
    EXPECT_EQ(text(4, "uint"), "4u");
    EXPECT_EQ(text(-4, "uint"), "none");
    EXPECT_EQ(text(2.5, "int"), "none");
    EXPECT_EQ(text(3e9, "int"), "none");
    EXPECT_EQ(text(1, "bool"), "true");
    EXPECT_EQ(text(1, "vec3"), "none");
    EXPECT_EQ(glsl::textOf({"N", "", false, {1, .5, -2}}, ""), "vec3(1.0, 0.5, -2.0)");
    EXPECT_EQ(glsl::textOf({"N", "", false, {1, 2}}, "uvec2"), "uvec2(1u, 2u)");
    EXPECT_EQ(glsl::textOf({"N", "", true, {1}}, ""), "true");
}

TEST(Constants, ReplaceDefinesAndConstVariables) {
    for (const std::string& declaration :
         {std::string(), std::string("#define N 4\n"), std::string("#ifndef N\n#define N 4\n#endif\n")}) {
        const TranslatedProgram translated = fragmentWith({number("N", 7)}, declaration + kMain);
        EXPECT_EQ(ids(translated.diagnostics), "") << declaration;
        EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "c = vec4 ( float ( 7 ) )"))
            << declaration;
    }
    const auto source = [](const Constant& constant, const std::string& text) {
        const TranslatedProgram translated = fragmentWith({constant}, text + kMain);
        EXPECT_EQ(ids(translated.diagnostics), "") << text;
        return sourceOf(translated, Stage::fragment);
    };
    EXPECT_TRUE(hasTokens(source(number("N", 7), "const int N = 4;\n"), "const int N = 7;"));
    EXPECT_TRUE(
        hasTokens(source(number("N", 7), "const float N = float(3) * (1. + 2.);\n"), "const float N = 7.0;"));
    EXPECT_TRUE(hasTokens(source(number("N", 7), "const int A = 1, N = 4, B = N + A;\n"),
                          "const int A = 1, N = 7, B = N + A;"));
    EXPECT_TRUE(hasTokens(source(number("N", 7), "#define N 4.\n"), "float ( 7.0 )"));
    EXPECT_TRUE(hasTokens(source(number("N", -7), "#define TWICE (2 * N)\nconst int M = TWICE;\n"),
                          "const int M = (2 * (-7));"));
}

TEST(Constants, DecideConditionsAndSizes) {
    const std::string text =
        "#if N > 2\nconst int kind = 1;\n#else\nconst int kind = 2;\n#endif\nfloat a[N];\n" +
        std::string(kMain);
    EXPECT_TRUE(hasTokens(sourceOf(fragmentWith({number("N", 3)}, text), Stage::fragment), "kind = 1"));
    EXPECT_TRUE(hasTokens(sourceOf(fragmentWith({number("N", 2)}, text), Stage::fragment), "kind = 2"));
    const std::string flag =
        "#if N\nconst int kind = 1;\n#else\nconst int kind = 2;\n#endif\n" + std::string(kMain);
    EXPECT_TRUE(hasTokens(sourceOf(fragmentWith({{"N", "", true, {1}}}, flag), Stage::fragment), "kind = 1"));
    EXPECT_TRUE(hasTokens(sourceOf(fragmentWith({{"N", "", true, {0}}}, flag), Stage::fragment), "kind = 2"));
    const TranslatedProgram compute =
        translatedWith({number("N", 16)},
                       {{Stage::compute, "#version 430\nlayout(local_size_x = N) in;\nvoid main() {}\n"}});
    EXPECT_EQ(ids(compute.diagnostics), "");
    EXPECT_TRUE(hasTokens(sourceOf(compute, Stage::compute), "local_size_x = 16"));
}

TEST(Constants, ThatNoShaderNamesAreReported) {
    const TranslatedProgram translated = fragmentWith({number("N", 1), number("M", 2)}, kMain);
    EXPECT_EQ(ids(translated.diagnostics), "glsl-W33");
    EXPECT_EQ(placeOf(translated.diagnostics, "glsl-W33").line, 6);
    // A name of one stage is enough, and #ifdef names it.
    EXPECT_EQ(ids(fragmentWith({number("N", 1)},
                               "#ifdef N\n#endif\nout vec4 c;\nvoid main() { c = "
                               "vec4(1.); }\n")
                      .diagnostics),
              "");
}

TEST(Constants, ThatDoNotFitTheirDeclarationAreErrors) {
    const auto problem = [](const Constant& constant, const std::string& text) {
        const TranslatedProgram translated = fragmentWith({constant}, text + kMain);
        EXPECT_EQ(ids(translated.diagnostics), "glsl-E18") << text;
        EXPECT_EQ(placeOf(translated.diagnostics, "glsl-E18").line, 2) << text;
        return test::textOf(translated.diagnostics, "glsl-E18");
    };
    EXPECT_EQ(problem(number("N", 2.5), "const int N = 4;\n"),
              "'N' is declared as int, and the scene gives it 2.5");
    EXPECT_EQ(problem(number("N", 2), "const vec3 N = vec3(1);\n"),
              "'N' is declared as vec3, and the scene gives it 2");
    EXPECT_EQ(problem(number("N", 2, "float"), "const int N = 4;\n"),
              "'N' is declared as int, and the scene gives it float 2");
    EXPECT_EQ(problem(number("N", 2), "uniform float N;\n"),
              "'N' is a constant that the Program statement gives, so it is declared as 'const float N = "
              "...;', as a #define or not at all");
    EXPECT_EQ(problem(number("N", 2), "#define N(x) x\n"),
              "'N' takes arguments here, and the scene gives it 2");
}

TEST(Constants, KeepTheLinesOfMessages) {
    const TranslatedProgram translated =
        fragmentWith({{"N", "", false, {1, 2, 3}}},
                     "const vec3 N = vec3(1.,\n  2.,\n  3.);\nuniform float "
                     "gl_x;\nout vec4 c;\nvoid main() { c = vec4(N, 1.); }\n");
    EXPECT_TRUE(hasTokens(sourceOf(translated, Stage::fragment), "const vec3 N = vec3(1.0, 2.0, 3.0);"));
    EXPECT_TRUE(translated.diagnostics.empty() || translated.diagnostics[0].place.line == 5);
}

}  // namespace
}  // namespace glibra::glsl::test
