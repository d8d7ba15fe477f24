// Every keyword and reserved word of the target is a name in the versions that leave it to the user
// (language, 7.4): of variables, functions, parameters, structures, members, blocks and macros.

#include <gtest/gtest.h>

#include <algorithm>

#include "glsl/read/words.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

struct WordVersion {
    const char* text;
    int version, written;
    bool hasBlocks;
};
constexpr WordVersion kWordVersions[] = {
    {"100", 120, 100, false},   {"110", 110, 110, false},  {"120", 120, 120, false},
    {"130", 130, 130, false},   {"150", 150, 150, true},   {"330", 330, 330, true},
    {"410", 410, 410, true},    {"450", 450, 450, true},   {"300 es", 330, 300, true},
    {"310 es", 430, 310, true}, {"320 es", 450, 320, true}};

std::vector<std::string> freeWords(const WordVersion& version) {
    Dialect dialect;
    dialect.version = version.version;
    dialect.written = version.written;
    dialect.es = version.written == 100 || version.written != version.version;
    std::vector<std::string> words;
    for (const std::string_view word : keywords())
        if (isFreeWord(word, dialect)) words.emplace_back(word);
    return words;
}

std::string withWord(std::string text, const std::string& word) {
    for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + word.size()))
        text.replace(at, 1, word);
    return text;
}

class FreeWords : public testing::TestWithParam<WordVersion> {
  protected:
    /// A fragment stage of the version, with `declarations` and `statements` for every free word: @ is the
    /// word.
    void expectToCompile(const std::string& declarations, const std::string& statements, std::size_t uses) {
        const WordVersion& version = GetParam();
        const bool isOld = version.version < 130;
        const bool isEs = version.written == 100 || version.written != version.version;
        std::string text = "#version " + std::string(version.text) +
                           (isEs ? "\nprecision highp float;" : "") + "\nuniform float uNumber;\n";
        if (!isOld) text += "out vec4 fColor;\n";
        std::string body;
        const std::vector<std::string> words = freeWords(version);
        for (const std::string& word : words) {
            text += withWord(declarations, word) + "\n";
            body += withWord(statements, word) + "\n";
        }
        text += "void main() {\nfloat sum = 0.;\n" + body + (isOld ? "gl_FragColor" : "fColor") +
                " = vec4(sum);\n}\n";
        const TranslatedProgram translated = translateSingle(Stage::fragment, text);
        std::size_t renamed = 0;
        for (const Diagnostic& each : translated.diagnostics) {
            renamed += each.id == "glsl-W05" ? 1 : 0;
            if (each.id != "glsl-W05" && each.id != "glsl-W03" && each.id != "glsl-W18")
                ADD_FAILURE() << each.text << " at " << each.place.line << "\n" << text;
        }
        EXPECT_EQ(renamed, uses * words.size());
        EXPECT_EQ("", glslangErrors(translated)) << text;
    }
};

TEST_P(FreeWords, NameVariables) {
    expectToCompile("uniform vec2 @;", "sum += @.x + (2. * @).y - max(@.x, @.y);", 1);
}

TEST_P(FreeWords, NameLocalVariables) {
    expectToCompile(
        "",
        "{ float first, @ = uNumber, last; @ += 1.; @++; if (@ > 2.) @ = -@; else @ *= 2.; sum += @; }\n"
        "{ vec2 @[2]; @[0] = vec2(1.); @[1] = @[0].yx; sum += @[1].x; }\n"
        "for (int @ = 0; @ < 2; @++) sum += float(@);",
        1);
}

TEST_P(FreeWords, NameParameters) {
    expectToCompile(
        "float of_@(float @); float of_@(float @) { return @ * 2.; }\n"
        "void set_@(in float a, out float @) { @ = a; }",
        "sum += of_@(1.); { float x; set_@(2., x); sum += x; }", 1);
}

TEST_P(FreeWords, NameFunctions) {
    expectToCompile("float @(float x) { return x; }\nvec2 @(vec2 x) { return x; }",
                    "sum += @(1.) + @(vec2(1.)).x;", 1);
}

TEST_P(FreeWords, NameStructures) {
    expectToCompile("struct @ { float a; };\n@ make_@() { @ made; made.a = 1.; return made; }",
                    "{ @ x = make_@(); sum += x.a + @(2.).a; }", 1);
}

TEST_P(FreeWords, NameMembers) {
    expectToCompile("struct In_@ { float first, @; vec2 last; };",
                    "{ In_@ y; y.@ = 1.; y.first = y.@; sum += y.first; }", 1);
}

TEST_P(FreeWords, NameMacros) {
    expectToCompile("#define @ 2.\n#undef @\n#define OF_@(@) ((@) * 2.)", "sum += OF_@(3.);", 0);
}

TEST_P(FreeWords, NameBlocksAndTheirMembers) {
    if (!GetParam().hasBlocks) return;
    expectToCompile("layout(std140) uniform Block_@ { layout(row_major) mat2 @; } in_@;",
                    "sum += in_@.@[0].x;", 1);
}

TEST_P(FreeWords, NameBlocks) {
    if (!GetParam().hasBlocks) return;
    expectToCompile("uniform @ { float of_@; };", "sum += of_@;", 1);
}

INSTANTIATE_TEST_SUITE_P(Versions, FreeWords, testing::ValuesIn(kWordVersions), [](const auto& version) {
    std::string name(version.param.text);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

/// The words of layout(...) in all stages (GLSL 4.50, 4.4): none but `shared` is a keyword.
TEST(LayoutWords, AreNamesInEveryVersion) {
    const std::vector<std::string> words = {"shared",
                                            "packed",
                                            "std140",
                                            "std430",
                                            "row_major",
                                            "column_major",
                                            "binding",
                                            "offset",
                                            "align",
                                            "location",
                                            "component",
                                            "index",
                                            "triangles",
                                            "quads",
                                            "isolines",
                                            "equal_spacing",
                                            "fractional_even_spacing",
                                            "fractional_odd_spacing",
                                            "cw",
                                            "ccw",
                                            "point_mode",
                                            "points",
                                            "lines",
                                            "lines_adjacency",
                                            "triangles_adjacency",
                                            "invocations",
                                            "origin_upper_left",
                                            "pixel_center_integer",
                                            "early_fragment_tests",
                                            "local_size_x",
                                            "local_size_y",
                                            "local_size_z",
                                            "xfb_buffer",
                                            "xfb_stride",
                                            "xfb_offset",
                                            "vertices",
                                            "line_strip",
                                            "triangle_strip",
                                            "max_vertices",
                                            "stream",
                                            "depth_any",
                                            "depth_greater",
                                            "depth_less",
                                            "depth_unchanged",
                                            "rgba32f",
                                            "rgba8",
                                            "r32ui",
                                            "r11f_g11f_b10f"};
    for (const char* const version :
         {"100", "110", "120", "130", "140", "150", "330", "400", "420", "450", "300 es", "320 es"}) {
        const bool isOld = std::string_view(version) < "130" || std::string_view(version) == "100";
        std::string text =
            "#version " + std::string(version) + "\nprecision highp float;\nuniform vec2 packed_;\n" +
            (isOld ? "" : "out vec4 fColor;\nlayout(std140, row_major) uniform Matrices { mat4 m; };\n") +
            "void main() {\nfloat sum = 0.;\n";
        for (const std::string& word : words)
            if (word != "shared" ||
                (std::string_view(version) != "450" && std::string_view(version) != "320 es"))
                text += withWord("{ float @ = 1.; sum += @; }\n", word);
        text += std::string(isOld ? "gl_FragColor = vec4(sum);" : "fColor = m[0] * sum;") + "\n}\n";
        const TranslatedProgram translated = translateSingle(Stage::fragment, text);
        EXPECT_FALSE(hasError(translated.diagnostics)) << version;
        EXPECT_EQ("", glslangErrors(translated)) << version;
        const std::string source = sourceOf(translated, Stage::fragment);
        EXPECT_EQ(std::string::npos, source.find("float row_major")) << version;  // some drivers refuse it
        if (!isOld) {
            EXPECT_NE(std::string::npos, source.find("layout(std140, row_major)")) << version;
        }
    }
}

TEST(FreeWords, AreKeywordsWhereNothingDeclaresThem) {
    // Written for a later version than declared: accepted, with the meaning of that version.
    const TranslatedProgram translated =
        translateSingle(Stage::fragment,
                        "#version 120\nflat varying vec2 vFlat; uniform sampler2DArray uLayers; uint "
                        "twice(const uint x, in uint y) { return x + y; }\n"
                        "void main() { uint n = uint(vFlat.x); switch (int(n)) { case 1: n = twice(n, 2u); "
                        "break; default: break; }\n"
                        "gl_FragColor = texture(uLayers, vec3(vFlat, float(n))); }\n");
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Precision, MayBeStatedInEveryBlock) {
    for (const char* const version : {"100", "120", "130", "330", "450", "300 es"}) {
        const bool isOld = std::string_view(version) == "100" || std::string_view(version) == "120";
        const TranslatedProgram translated = translateSingle(
            Stage::fragment, "#version " + std::string(version) + "\nprecision mediump float;\n" +
                                 (isOld ? "" : "out vec4 fColor;\n") +
                                 "highp float f(in highp float x, lowp vec2 y) { precision highp float; "
                                 "precision lowp int; float z = .5 * x; return z + y.x; }\n"
                                 "void main() { precision mediump sampler2D; float sum = 0.; for (int i = 0; "
                                 "i < 2; ++i) { precision lowp float; mediump float y = f(1., vec2(2.)); "
                                 "if (y > 0.) { precision highp int; sum += y; } }\n" +
                                 (isOld ? "gl_FragColor" : "fColor") + " = vec4(sum); }\n");
        EXPECT_FALSE(has(translated.diagnostics, "glsl-W05")) << version;
        EXPECT_EQ("", glslangErrors(translated)) << version;
    }
}

TEST(Sequences, AreConstantsInVersionsThatSaySo) {
    const std::string text =
        "#define PAIR (1., 2.)\nconst float a = (1., 2.); const float b = ((3., a), (4., a * PAIR));\n"
        "float list[(2, 3)];\nvoid main() { float i = 0.; const vec2 c = (vec2(1.), vec2(a, b)); list[0] = "
        "(i += 1., c.x); list[2] = max((1., i), b); "
        "for (int k = 0, n = 0; k < 2; ++k, ++n) list[1] = (float(k), i++, list[0]);\n";
    for (const char* const version : {"100", "110", "120", "330", "420"}) {
        const bool isOld = std::string_view(version) < "130";
        const TranslatedProgram translated = translateSingle(
            Stage::fragment, "#version " + std::string(version) + "\nprecision highp float;\n" +
                                 (isOld ? "" : "out vec4 fColor;\n") + text +
                                 (isOld ? "gl_FragColor" : "fColor") +
                                 " = vec4(list[0] + list[1] + list[2]); }\n");
        EXPECT_FALSE(hasError(translated.diagnostics)) << version;
        EXPECT_EQ("", glslangErrors(translated)) << version;
        const std::string source = userPart(translated, Stage::fragment);
        EXPECT_TRUE(hasTokens(source, "const float a = (2.);")) << source;
        EXPECT_TRUE(hasTokens(source, "list[0] = (i += 1., c.x);")) << source;
        EXPECT_TRUE(hasTokens(source, "(float(k), i++, list[0])")) << source;
    }
    EXPECT_TRUE(hasTokens(
        userPart(translateSingle(Stage::fragment, "#version 430\n" + text + "}\n"), Stage::fragment),
        "const float a = (1., 2.);"));
}

}  // namespace
}  // namespace glibra::glsl::test
