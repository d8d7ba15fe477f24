// Inputs that no stage writes read 0 (language, 7.9), whatever their type, sizes and qualifiers, and wherever
// a shader names them. And uniforms that two stages declare differently.

#include <gtest/gtest.h>

#include <algorithm>

#include "support.h"

namespace glibra::glsl::test {
namespace {

struct LostType {
    const char* word;
    const char* use;  ///< a float made of a value
    bool isInteger;
};
constexpr LostType kLostTypes[] = {
    {"float", "@", false},        {"vec2", "@.y", false},        {"vec3", "@.z", false},
    {"vec4", "@.w", false},       {"mat3", "@[2][1]", false},    {"mat2x4", "@[1].w", false},
    {"int", "float(@)", true},    {"uvec3", "float(@.y)", true}, {"Light", "@.color.g + @.weights[1]", false},
    {"dvec2", "float(@.y)", true}};

/// Declarations of an input: % is the type, and @ the name; and how an element is named.
struct LostForm {
    const char* declaration;
    const char* element;
};

std::string substituted(std::string text, char mark, const std::string& word) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + word.size()))
        text.replace(at, 1, word);
    return text;
}

const std::string kLostConstants =
    "const int kCount = 3;\nstruct Light { vec3 color; float weights[kCount - 1]; };\n";

/// A stage with one input of each type and form, all of them read.
std::string lostReader(const std::string& head, const std::vector<LostForm>& forms,
                       const std::string& qualifier, std::size_t& count) {
    std::string declarations, body;
    for (const LostType& type : kLostTypes)
        for (const LostForm& form : forms) {
            const std::string name = "vLost" + std::to_string(++count);
            declarations += (qualifier.empty() && type.isInteger ? "flat " : qualifier) + "in " +
                            substituted(substituted(form.declaration, '%', type.word), '@', name) + ";\n";
            body += "    sum += " + substituted(type.use, '@', substituted(form.element, '@', name)) + ";\n";
        }
    return head + kLostConstants + declarations + "float all() {\n    float sum = 0.;\n" + body +
           "    return sum;\n}\n";
}

void expectZeros(const Stages& stages, Stage stage, std::size_t count) {
    const TranslatedProgram translated = translateStages(stages);
    EXPECT_FALSE(hasError(translated.diagnostics)) << ids(translated.diagnostics);
    const auto warnings = std::count_if(translated.diagnostics.begin(), translated.diagnostics.end(),
                                        [](const Diagnostic& each) { return each.id == "glsl-W11"; });
    EXPECT_EQ(warnings, static_cast<std::ptrdiff_t>(count));
    EXPECT_EQ("", glslangErrors(translated)) << sourceOf(translated, stage);
    // Each of them has a value of its own.
    const std::string source = userPart(translated, stage);
    for (std::size_t i = 1; i <= count; ++i) {
        const std::string name = "vLost" + std::to_string(i);
        const std::size_t at = source.find(name);
        const std::string line = source.substr(at, source.find('\n', at) - at);
        EXPECT_NE(std::string::npos, line.find(" = ")) << line;
    }
}

const std::string kLostVertex = "#version 450\nvoid main() { gl_Position = vec4(1.); }\n";
const std::string kLostMain = "void main() { fColor = vec4(all()); }\n";

TEST(Unwritten, FragmentInputsOfEveryType) {
    std::size_t count = 0;
    const std::string text = lostReader("#version 450\nout vec4 fColor;\n",
                                        {{"% @", "@"},
                                         {"% @[2]", "@[1]"},
                                         {"% @[kCount]", "@[2]"},
                                         {"% @[kCount * 2 + 1]", "@[6]"},
                                         {"%[2] @", "@[1]"},
                                         {"% @[2][kCount]", "@[1][2]"},
                                         {"%[kCount] @[2]", "@[1][2]"},
                                         {"% @[]", "@[4]"},
                                         {"highp % @", "@"}},
                                        "", count);
    expectZeros({{Stage::vertex, kLostVertex}, {Stage::fragment, text + kLostMain}}, Stage::fragment, count);
}

TEST(Unwritten, FragmentInputsWithEveryQualifier) {
    for (const char* const qualifier : {"flat ", "flat centroid ", "flat sample "}) {
        std::size_t count = 0;
        const std::string text = lostReader("#version 450\nout vec4 fColor;\n",
                                            {{"% @", "@"}, {"% @[2]", "@[1]"}}, qualifier, count);
        expectZeros({{Stage::vertex, kLostVertex}, {Stage::fragment, text + kLostMain}}, Stage::fragment,
                    count);
    }
}

TEST(Unwritten, InputsPerVertex) {
    const std::vector<LostForm> forms = {
        {"% @[]", "@[1]"}, {"%[] @", "@[1]"}, {"% @[][2]", "@[1][1]"}, {"% @[][kCount]", "@[1][2]"}};
    std::size_t count = 0;
    const std::string geometry =
        lostReader("#version 450\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n",
                   forms, "", count);
    expectZeros({{Stage::vertex, kLostVertex},
                 {Stage::geometry, geometry + "void main() { gl_Position = vec4(all()); EmitVertex(); }\n"},
                 {Stage::fragment, "#version 450\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n"}},
                Stage::geometry, count);
    count = 0;
    const std::string control = lostReader("#version 450\nlayout(vertices = 3) out;\n", forms, "", count);
    const std::string kLostEvaluation =
        "#version 450\nlayout(triangles) in;\nvoid main() { gl_Position = gl_in[0].gl_Position; }\n";
    expectZeros({{Stage::vertex, kLostVertex},
                 {Stage::tessControl,
                  control + "void main() { gl_out[gl_InvocationID].gl_Position = vec4(all()); }\n"},
                 {Stage::tessEvaluation, kLostEvaluation}},
                Stage::tessControl, count);
    const std::string kLostControl =
        "#version 450\nlayout(vertices = 3) out;\nvoid main() { gl_out[gl_InvocationID].gl_Position = "
        "vec4(1.); }\n";
    count = 0;
    const std::string evaluation = lostReader("#version 450\nlayout(triangles) in;\n", forms, "", count);
    expectZeros({{Stage::vertex, kLostVertex},
                 {Stage::tessControl, kLostControl},
                 {Stage::tessEvaluation, evaluation + "void main() { gl_Position = vec4(all()); }\n"}},
                Stage::tessEvaluation, count);
    count = 0;
    const std::string patch = lostReader("#version 450\nlayout(triangles) in;\n",
                                         {{"% @", "@"}, {"% @[kCount]", "@[2]"}}, "patch ", count);
    expectZeros({{Stage::vertex, kLostVertex},
                 {Stage::tessControl, kLostControl},
                 {Stage::tessEvaluation, patch + "void main() { gl_Position = vec4(all()); }\n"}},
                Stage::tessEvaluation, count);
}

TEST(Unwritten, InputsAreInterpolatedAnywhere) {
    std::string declarations, body;
    std::size_t count = 0;
    for (const char* const type : {"float", "vec2", "vec3", "vec4"})
        for (const char* const call :
             {"interpolateAtCentroid(@)", "interpolateAtSample(@, 1)", "interpolateAtOffset(@, vec2(.1))"})
            for (const char* const element : {"@", "@[1]"}) {
                const std::string name = "vLost" + std::to_string(++count);
                declarations += "centroid in " + std::string(type) + " " + name +
                                (element[1] == '[' ? "[2]" : "") + ";\n";
                body += "sum += vec4(" + substituted(call, '@', substituted(element, '@', name)) +
                        (std::string_view(type) == "float" ? "" : ".x") + ");\n";
            }
    const std::string text = "#version 400 compatibility\n#define AT interpolateAtCentroid\nin vec2 vST;\n" +
                             declarations +
                             "centroid in vec2 vMacro;\nvoid main() {\nvec4 sum = "
                             "vec4(interpolateAtCentroid(vST), AT(vMacro));\n" +
                             body + "gl_FragColor = sum;\n}\n";
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex,
          "#version 120\nvarying vec2 vST;\nvoid main() { vST = gl_Vertex.xy; gl_Position = gl_Vertex; }\n"},
         {Stage::fragment, text}});
    EXPECT_EQ("", glslangErrors(translated)) << sourceOf(translated, Stage::fragment);
    EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "interpolateAtCentroid(vST)"));
}

TEST(Unwritten, BlocksWithArrays) {
    const std::string fragment =
        "#version 450\n" + kLostConstants +
        "out vec4 fColor;\n"
        "in Lost { vec3 a; float b[kCount]; vec2 c[kCount][2]; Light light; } lost;\n"
        "in Open { vec4 d[2]; float e; };\n"
        "void main() { fColor = vec4(lost.a, lost.b[2] + lost.c[2][1].y + lost.light.weights[1]) + d[1] + e "
        "+ interpolateAtCentroid(lost.a).x + interpolateAtSample(e, 0); }\n";
    const TranslatedProgram translated =
        translateStages({{Stage::vertex, kLostVertex}, {Stage::fragment, fragment}});
    EXPECT_EQ("glsl-W11 glsl-W11", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated)) << sourceOf(translated, Stage::fragment);
}

// Uniforms:

std::string uniformMismatch(const std::string& vertex, const std::string& fragment) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex, "#version 430\n" + vertex + "\nvoid main() { gl_Position = vec4(1.); }\n"},
         {Stage::fragment,
          "#version 430\n" + fragment + "\nout vec4 fColor;\nvoid main() { fColor = vec4(1.); }\n"}});
    return textOf(translated.diagnostics, "glsl-E02");
}

TEST(UniformTypes, AreTheSameInAllStages) {
    EXPECT_EQ("'u' is vec4 in a.vert:2 and vec3 in a.frag:2",
              uniformMismatch("uniform vec4 u;", "uniform vec3 u;"));
    EXPECT_EQ("'u' is float[3] in a.vert:2 and float[4] in a.frag:3",
              uniformMismatch("uniform float u[3];", "const int n = 4;\nuniform float u[n];"));
    EXPECT_EQ("'u' is float in a.vert:2 and float[2] in a.frag:2",
              uniformMismatch("uniform float u;", "uniform float u[2];"));
    EXPECT_EQ("'u' is sampler2D in a.vert:2 and sampler3D in a.frag:2",
              uniformMismatch("uniform sampler2D u;", "uniform sampler3D u;"));
    EXPECT_EQ("'u' is S { vec3 a; } in a.vert:2 and S { vec4 a; } in a.frag:2",
              uniformMismatch("struct S { vec3 a; }; uniform S u;", "struct S { vec4 a; }; uniform S u;"));
    EXPECT_EQ("'B' is { vec4 a; float b; } in a.vert:2 and { vec4 a; vec2 b; } in a.frag:2",
              uniformMismatch("uniform B { vec4 a; float b; };", "uniform B { vec4 a; vec2 b; } named;"));
}

TEST(UniformTypes, MayBeWrittenInSeveralWays) {
    for (const auto& [vertex, fragment] :
         {std::pair{"uniform vec4 u;", "uniform highp vec4 u;"},
          std::pair{"uniform float u[4];", "const int n = 2;\nuniform float[n * 2] u;"},
          std::pair{"uniform float u[];\nfloat f() { return u[3]; }", "uniform float u[4];"},
          std::pair{"struct S { vec3 a, b; }; uniform S u;", "struct S { vec3 a; vec3 b; }; uniform S u;"},
          std::pair{"uniform B { vec4 a; vec2 b; };", "layout(std140) uniform B { highp vec4 a; vec2 b; };"},
          std::pair{"uniform vec4 u;", "in vec3 u; uniform vec3 v;"},
          std::pair{"uniform int u = 3;", "layout(location = 3) uniform int u;"}})
        EXPECT_EQ("", uniformMismatch(vertex, fragment)) << vertex;
}

// Implicit conversions:

TEST(Conversions, AreWrittenWhereDriversDisagree) {
    const std::pair<const char*, const char*> kCases[] = {
        {"smoothstep(0., 1, x)", "smoothstep(0., float(1), x)"},
        {"smoothstep(n, 2, x)", "smoothstep(float(n), float(2), x)"},
        {"clamp(x, 0, 1)", "clamp(x, float(0), float(1))"},
        {"max(n, x)", "max(float(n), x)"},
        {"min(n, 3)", "min(n, 3)"},
        {"float(min(m, 3))", "float(min(m, uint(3)))"},
        {"mix(x, 1, x > 0.)", "mix(x, float(1), x > 0.)"},
        {"abs(m)", "abs(float(m))"},
        {"mix(x, 1, .5)", "mix(x, float(1), .5)"},
        {"pow(2, x)", "pow(float(2), x)"},
        {"sqrt(2)", "sqrt(float(2))"},
        {"length(p)", "length(vec2(p))"},
        {"dot(p, v)", "dot(vec2(p), v)"},
        {"mod(n + 1, 2.)", "mod(float(n + 1), 2.)"},
        {"atan(x, 1)", "atan(x, float(1))"},
        {"float(max(d, 1))", "float(max(d, double(1)))"},
        {"abs(float(n))", "abs(float(n))"},
        {"x * n", "x * n"},
    };
    for (const auto& [call, emitted] : kCases) {
        const TranslatedProgram translated =
            translateSingle(Stage::fragment,
                            "#version 400\nuniform float x; uniform int n; uniform uint m; uniform ivec2 p; "
                            "uniform vec2 v; uniform double d;\n"
                            "out vec4 o;\nvoid main() { o = vec4(" +
                                std::string(call) + "); }\n");
        EXPECT_EQ("", ids(translated.diagnostics)) << call;
        EXPECT_TRUE(hasTokens(userPart(translated, Stage::fragment), "vec4(" + std::string(emitted) + ")"))
            << userPart(translated, Stage::fragment);
        EXPECT_EQ("", glslangErrors(translated)) << call;
    }
    // A function of the user's own takes what it takes.
    EXPECT_TRUE(hasTokens(
        userFragment(
            "float pow(int a, float b) { return b; }\nout vec4 o; void main() { o = vec4(pow(2, 3.)); }"),
        "pow(2, 3.)"));
}

}  // namespace
}  // namespace glibra::glsl::test
