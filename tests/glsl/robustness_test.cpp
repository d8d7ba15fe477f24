// Damaged and hostile sources: the translation ends in time and reads no memory that is not its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "glsl/es/es.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// A counter-based hash (Wellons 2018, "lowbias32"), which gives the same values everywhere.
std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

const std::string kSource = R"(#version 120
#extension GL_EXT_geometry_shader4 : enable
#define SQ(x) ((x) * (x))
#define V varying
#if defined(SQ) && __VERSION__ >= 110
uniform int uTex, sample; uniform vec3 uA = vec3(1.), uB;;
#else
uniform float other;
#endif
V in vec3 vN[gl_VerticesIn]; varying out vec4 gC; flat varying vec2 vS;
const vec3 kC = uA * 2.;
struct Light { vec3 pos; float list[3]; } lights[2];
in Block { vec4 a; } block[];
subroutine float Kind(float x); subroutine uniform Kind kind;
float helper(in float x, out vec3 y) { y = const vec3(x); return pow(vec3(x), 2.).x; }
void main(void) {
    vec3 local = pow(vN[0], .5), b; for (int i = 0; i < gl_VerticesIn; i++) { gl_Position = gl_PositionIn[i]; local += SQ(local) \
 + texture2D(uTex, local.xy).rgb; EmitVertex(); }
    float w[3] = { 1., 2., 3. }; vN[0] *= helper(w[0], local); gl_FrontColor = gl_LightSource[0].diffuse + noise4(1.) + ftransform();
    gl_TexCoord[1] = gl_TexCoordIn[0][1]; gl_FragColor = gl_Color; gl_FragData[2] = vec4(mix(vec3(0.), 1., .5), Timer); // end \
}
)";

void translateEverywhere(const std::string& text, std::uint32_t seed) {
    const auto stage = static_cast<Stage>(seed % kStageCount);
    ProgramRequest request = program({{stage, text}, {seed & 1U ? Stage::fragment : Stage::vertex, kSource}});
    request.target.version = seed & 2U ? 410 : 450;
    request.include = [&](std::string_view, std::string_view) {
        return IncludedFile{"inc", text.substr(0, 200)};
    };
    const TranslatedProgram translated = translate(request);
    EXPECT_TRUE(!translated.stages.empty() || hasError(translated.diagnostics));
    std::vector<TranslatedStage> stages = translated.stages;
    if (!hasError(translated.diagnostics))
        for (TranslatedStage& each : toEs(translated).stages) stages.push_back(std::move(each));
    for (const TranslatedStage& each : stages)
        EXPECT_EQ(static_cast<std::size_t>(std::count(each.source.begin(), each.source.end(), '\n')),
                  each.lineMap.lines.size());
}

TEST(Robustness, MutatedSourcesEnd) {
    static const std::string kPieces = "(){}[];,.#\\\n\"/* =+<>?:0.xgl_";
    for (std::uint32_t seed = 0; seed < (GLIBRA_SANITIZED ? 1000 : 3000); ++seed) {
        std::string text = kSource;
        for (std::uint32_t k = 0; k < 1 + seed % 5; ++k) {
            const std::uint32_t random = mix(seed * 16 + k);
            const std::size_t at = random % text.size();
            const std::size_t length = mix(random) % 20;
            switch (random >> 29) {
                case 0:
                    text.erase(at, length);
                    break;
                case 1:
                    text.insert(at, 1, kPieces[mix(random + 1) % kPieces.size()]);
                    break;
                case 2:
                    text[at] = static_cast<char>(mix(random + 2) & 255U);
                    break;
                case 3:
                    text.insert(at, text.substr(mix(random + 3) % text.size(), length * 4));
                    break;
                case 4:
                    text.resize(at + 1);
                    break;
                case 5:
                    text.insert(at, "#include \"x\"\n");
                    break;
                default:
                    text[at] = kPieces[mix(random + 4) % kPieces.size()];
                    break;
            }
        }
        translateEverywhere(text, seed);
    }
}

TEST(Robustness, EveryPrefixEnds) {
    for (std::size_t length = 1; length < kSource.size(); ++length)
        translateEverywhere(kSource.substr(0, length), static_cast<std::uint32_t>(length));
}

std::string repeated(std::string_view part, std::size_t bytes) {
    std::string text;
    while (text.size() < bytes) text += part;
    return text;
}

TEST(Robustness, DeepNestingEnds) {
    for (const char* open : {"(",         "[",
                             "{",         "a(",
                             "a[",        "a?",
                             "-",         "!",
                             "const ",    "x = ",
                             "struct S{", "if(",
                             "for(;;)",   "vec3(",
                             "pow(a, ",   "gl_PositionIn[",
                             "layout(",   "subroutine(",
                             "f(g,",      "1+",
                             "a.",        "in vec3 ",
                             "{{",        "#if 1\n",
                             "/*",        "#define A(x) x\n"})
        for (const char* before : {"void main() { x = ", "", "float a = ", "uniform "}) {
            const std::string text =
                "#version 120\n" + std::string(before) + repeated(open, GLIBRA_SANITIZED ? 5'000 : 40'000);
            for (const Stage stage : {Stage::vertex, Stage::geometry, Stage::fragment})
                translateSingle(stage, text);
        }
}

TEST(Robustness, MacroBombsAreBounded) {
    std::string text = "#version 330\n#define A0 x x\n";
    for (int i = 1; i < 40; ++i)
        text += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + " A" +
                std::to_string(i - 1) + "\n";
    text += "float y = A39;\n#if A39\n#endif\n";
    translateSingle(Stage::vertex, text);
    std::string empty = "#version 330\n#define A0\n";
    for (int i = 1; i < 40; ++i)
        empty += "#define A" + std::to_string(i) + "(a) A" + std::to_string(i - 1) + "(a) A" +
                 std::to_string(i - 1) + "(a)\n";
    translateSingle(Stage::vertex, empty + "float y = A39(A39(1));\n");
    translateSingle(Stage::vertex,
                    "#version 330\n#define A B\n#define B A\n#define F(x) F(F(x))\nfloat y = A + F(F(1));\n");
}

TEST(Robustness, LargeSourcesEnd) {
    for (const char* part :
         {"uniform float a;\n", "a b c d;\n", "void f() { g(1, 2); }\n", "x = pow(a, 2.);\n", ";",
          "#define X 1\n", "#if 0\n#endif\n", "gl_PositionIn[0];\n", "\\\n", "// \\\n",
          "varying vec3 a, b;\n", "0", "a", "\"", "struct S { int a; };\n"})
        for (const Stage stage : {Stage::vertex, Stage::geometry, Stage::fragment})
            translateSingle(stage, "#version 120\n" + repeated(part, GLIBRA_SANITIZED ? 40'000 : 300'000));
}

TEST(Robustness, LineZeroCountsAsLineOne) {
    const TranslatedProgram translated =
        translateSingle(Stage::fragment, "#version 430\n#line 0\nuniform float glibra_x; void main() { }");
    EXPECT_EQ(1, placeOf(translated.diagnostics, "glsl-E05").line);
}

TEST(Robustness, SubroutineUniformWithTheNameOfAnOldValue) {
    const TranslatedProgram translated = translateSingle(
        Stage::fragment,
        "#version 430\nsubroutine float A(float x);\nsubroutine(A) float one(float x) { return x; }\n"
        "subroutine uniform A gl_LightSource;\nvoid main() { }");
    EXPECT_EQ("glsl-W04", ids(translated.diagnostics));
}

}  // namespace
}  // namespace glibra::glsl::test
