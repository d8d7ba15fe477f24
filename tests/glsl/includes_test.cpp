// #include, #line, #pragma once, conditional branches, and the map of lines (language, 7.11).

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support.h"

namespace glibra::glsl::test {
namespace {

/// A request whose included files come from a table.
ProgramRequest withFiles(const std::string& text, std::map<std::string, std::string> files) {
    ProgramRequest request = single(Stage::fragment, text);
    request.include = [files = std::move(files)](std::string_view name,
                                                 std::string_view) -> std::optional<IncludedFile> {
        const auto found = files.find(std::string(name));
        if (found == files.end()) return std::nullopt;
        return IncludedFile{found->first, found->second};
    };
    return request;
}

/// The origin, as "file:line", of the emitted line that contains `part`.
std::string originOf(const TranslatedProgram& translated, const std::string& part) {
    const TranslatedStage& stage = translated.stages.front();
    const std::size_t at = stage.source.find(part);
    if (at == std::string::npos) return "not found";
    const auto line = static_cast<std::size_t>(
        std::count(stage.source.begin(), stage.source.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    const LineOrigin origin = stage.lineMap.lines[line];
    return origin.file < 0 ? "own"
                           : stage.lineMap.files[static_cast<std::size_t>(origin.file)] + ":" +
                                 std::to_string(origin.line);
}

TEST(Include, IsExpandedWithItsOwnLines) {
    const TranslatedProgram translated = translate(
        withFiles("#version 120\n#include \"half.glsl\"\nvoid main() { gl_FragColor = vec4(twice(2.)); }\n",
                  {{"half.glsl", "// first\nfloat twice(float x) { return 2. * x; }"}}));
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("half.glsl:2", originOf(translated, "float twice"));
    EXPECT_EQ("a.frag:3", originOf(translated, "void main()"));
    EXPECT_EQ("own", originOf(translated, "#version"));
    EXPECT_TRUE(hasTokens(translated.stages[0].source, "#line 1 1"));
    EXPECT_TRUE(hasTokens(translated.stages[0].source, "#line 3 0"));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Include, AngleBracketsAndQuotedNumbersInLines) {
    ProgramRequest request =
        withFiles("#version 330\n#include <lib/f.glsl>\nout vec4 o; void main() { o = vec4(f()); }\n",
                  {{"lib/f.glsl", "float f() { return 1.; }\n"}});
    request.target.lineDirectiveTakesFileName = true;
    const std::string source = sourceOf(translate(request), Stage::fragment);
    EXPECT_NE(std::string::npos, source.find("#extension GL_ARB_shading_language_include : enable\n"));
    EXPECT_NE(std::string::npos, source.find("#line 1 \"1\"\n"));
    EXPECT_NE(std::string::npos, source.find("#line 3 \"0\"\n"));
}

TEST(Include, MissingFileIsAnErrorWhereItIsCompiled) {
    const TranslatedProgram translated = translate(
        withFiles("#version 330\n#include \"no.glsl\"\nout vec4 o; void main() { o = vec4(1.); }\n", {}));
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_NE(std::string::npos,
              sourceOf(translated, Stage::fragment).find("#error cannot find the included file 'no.glsl'"));
    const TranslatedProgram inactive = translate(withFiles(
        "#version 330\n#if 0\n#include \"no.glsl\"\n#endif\nout vec4 o; void main() { o = vec4(1.); }\n",
        {}));
    EXPECT_EQ("", glslangErrors(inactive));
}

TEST(Include, CycleIsNamed) {
    const TranslatedProgram translated =
        translate(withFiles("#version 330\n#include \"a.glsl\"\n",
                            {{"a.glsl", "#include \"b.glsl\"\n"}, {"b.glsl", "#include \"a.glsl\"\n"}}));
    EXPECT_EQ("#include cycle: a.frag, a.glsl, b.glsl, a.glsl", textOf(translated.diagnostics, "glsl-E04"));
}

TEST(Include, PragmaOnceIsHonoured) {
    const TranslatedProgram translated =
        translate(withFiles("#version 330\n#include \"f.glsl\"\n#include \"f.glsl\"\nout vec4 o; void main() "
                            "{ o = vec4(f()); }\n",
                            {{"f.glsl", "#pragma once\nfloat f() { return 1.; }\n"}}));
    EXPECT_EQ("", ids(translated.diagnostics));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Include, GuardsWork) {
    const TranslatedProgram translated = translate(
        withFiles("#version 330\n#include \"f.glsl\"\n#include \"f.glsl\"\nout vec4 o; void main() { o = "
                  "vec4(f()); }\n",
                  {{"f.glsl", "#ifndef F_GLSL\n#define F_GLSL\nfloat f() { return 1.; }\n#endif\n"}}));
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Include, RulesSeeIncludedDeclarations) {
    const TranslatedProgram translated = translate(withFiles(
        "#version 120\n#include \"u.glsl\"\nvoid main() { gl_FragColor = texture2D(s, vec2(uX)); }\n",
        {{"u.glsl", "uniform int s;;\nuniform float uX;"}}));
    EXPECT_EQ("u.glsl", placeOf(translated.diagnostics, "glsl-W12").file);
    EXPECT_EQ("u.glsl", translated.uniforms.at("uX").place.file);
    EXPECT_EQ(2, translated.uniforms.at("uX").place.line);
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Include, LimitsHold) {
    std::map<std::string, std::string> files;
    for (int i = 0; i < 40; ++i)
        files["f" + std::to_string(i)] = "#include \"f" + std::to_string(i + 1) + "\"\n";
    EXPECT_TRUE(has(translate(withFiles("#version 330\n#include \"f0\"\n", files)).diagnostics, "file-E09"));
    files = {{"big", std::string(3U << 20, ' ')}};
    EXPECT_TRUE(
        has(translate(withFiles("#version 330\n#include \"big\"\n#include \"big\"\n", files)).diagnostics,
            "file-E09"));
    std::string many = "#version 330\n";
    for (int i = 0; i < 300; ++i) many += "#include \"one\"\n";
    EXPECT_TRUE(has(translate(withFiles(many, {{"one", "\n"}})).diagnostics, "file-E09"));
    EXPECT_TRUE(has(translateSingle(Stage::vertex, std::string(5U << 20, '\n')).diagnostics, "file-E09"));
}

TEST(Line, MeaningFollowsTheDeclaredVersion) {
    const auto emitted = [](const std::string& version) {
        return userPart(translateSingle(Stage::vertex, "#version " + version + "\n#line 40 3\nint x = 1;\n"),
                        Stage::vertex);
    };
    EXPECT_TRUE(hasTokens(emitted("120"), "#line 41 0 int x = 1;"));
    EXPECT_TRUE(hasTokens(emitted("150"), "#line 41 0 int x = 1;"));
    EXPECT_TRUE(hasTokens(emitted("330"), "#line 40 0 int x = 1;"));
}

TEST(Line, PlacesUseTheNewNumbers) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex, "#version 330\n#define N 100\n#line N\n;\n");
    EXPECT_EQ(100, placeOf(translated.diagnostics, "glsl-W09").line);
    EXPECT_EQ("a.vert:100",
              originOf(translateSingle(
                           Stage::vertex,
                           "#version 330\n#line 100\nint here;\nvoid main() { gl_Position = vec4(0.); }"),
                       "int here"));
}

TEST(Conditions, AreEvaluatedWithMacros) {
    const auto taken = [](const std::string& condition) {
        return translateSingle(Stage::vertex,
                               "#version 330\n#define A 3\n#define B(x) ((x) * 2)\n#define EMPTY\n#if " +
                                   condition +
                                   "\nuniform float yes;\n#endif\nvoid main() { gl_Position = vec4(0.); }")
            .uniforms.contains("yes");
    };
    for (const char* yes : {"1", "A == 3", "B(A) == 6", "defined(A) && defined B", "!defined(C)",
                            "A > 2 && A < 4 || 0", "(A << 2) == 12", "-1 < 0", "~0 == -1", "0x10 == 16",
                            "7 % 4 == 3", "C == 0", "__VERSION__ >= 330", "defined(GL_EXT_gpu_shader4)"})
        EXPECT_TRUE(taken(yes)) << yes;
    for (const char* no : {"0", "A != 3", "defined(C)", "1 / 0", "EMPTY", "(", "1 +", "GL_ES", "A - 3"})
        EXPECT_FALSE(taken(no)) << no;
}

TEST(Conditions, ElifAndNestingWork) {
    const TranslatedProgram translated = translateSingle(
        Stage::vertex,
        "#version 330\n#if 0\n#if 1\nuniform float a;\n#else\nuniform float b;\n#endif\n#elif 1\n#ifdef "
        "X\nuniform float c;\n#else\nuniform float d;\n#endif\n#elif 1\nuniform float e;\n#else\nuniform "
        "float f;\n#endif\nvoid main() { gl_Position = vec4(0.); }");
    ASSERT_EQ(1U, translated.uniforms.size());
    EXPECT_TRUE(translated.uniforms.contains("d"));
}

TEST(Conditions, UndefTakesAMacroAway) {
    const TranslatedProgram translated =
        translateSingle(Stage::vertex,
                        "#version 330\n#define T float\nuniform T a;\n#undef T\n#define T vec3\nuniform T "
                        "b;\nvoid main() { gl_Position = vec4(a, b); }");
    EXPECT_EQ("", glslangErrors(translated));
}

TEST(Include, ThatFailsInsideAnotherIsAtItsOwnLine) {
    const std::pair<const char*, const char*> cases[] = {
        {"// k\n#define K .5\n#include \"gone.h\"\n", "k.glsl:3"},
        {"#include \"gone.h\"\n", "k.glsl:1"},
        {"\n#include\n", "k.glsl:2"},
        {"#include \"deep.glsl\"\n", "deep.glsl:2"}};
    for (const auto& [text, place] : cases)
        for (const bool shim : {true, false}) {
            ProgramRequest request =
                withFiles("#version 120\n\n\n#include \"k.glsl\"\n#include \"k.glsl\"\nvoid main() {}\n",
                          {{"k.glsl", text}, {"deep.glsl", "\n#include \"gone.h\""}});
            request.shim = shim;
            EXPECT_EQ(originOf(translate(request), "#error"), place) << text << shim;
        }
}

TEST(Include, OfWhatIsNoTextIsRefusedOnce) {
    const std::string wide("f\0l\0o\0a\0t\0 \0x\0;\0\n\0", 18);
    const TranslatedProgram translated = translate(
        withFiles("#version 330\n#include \"k.glsl\"\nvoid main() {}\n", {{"k.glsl", "\xff\xfe" + wide}}));
    EXPECT_EQ(ids(translated.diagnostics), "file-E08");
    EXPECT_EQ(textOf(translated.diagnostics, "file-E08"), "'k.glsl' is UTF-16 text; save it as UTF-8");
    EXPECT_EQ(ids(translateSingle(Stage::fragment, "#version 330\n" + wide).diagnostics), "file-E08");
}

TEST(Lines, EveryEmittedLineHasAnOrigin) {
    const TranslatedProgram translated =
        translate(withFiles("#version 120\n/* a\n b */ #include \"f\"\n#define M \\\n 2\nvoid main() { "
                            "gl_FrontColor = gl_Color; \\\n }\n",
                            {{"f", "float f;"}}));
    for (const TranslatedStage& stage : translated.stages) {
        EXPECT_EQ(static_cast<std::size_t>(std::count(stage.source.begin(), stage.source.end(), '\n')),
                  stage.lineMap.lines.size());
        EXPECT_EQ(stage.lineMap.lines.size(), stage.lineMap.columns.size());
    }
}

TEST(NoShim, OnlyVersionAndIncludesAreHandled) {
    ProgramRequest request = withFiles(
        "#version 1.20\n#include \"f\"\nvoid main() { gl_FragColor = texture2D(s, vec2(0.)) * gl_Color; };\n",
        {{"f", "uniform sampler2D s;\n"}});
    request.shim = false;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("glsl-W02", ids(translated.diagnostics));
    const std::string source = sourceOf(translated, Stage::fragment);
    EXPECT_EQ("#version 120", source.substr(0, source.find('\n')));
    EXPECT_TRUE(hasTokens(source, "#line 0 1 uniform sampler2D s; #line 2 0"));
    EXPECT_TRUE(hasTokens(source, "gl_FragColor = texture2D(s, vec2(0.)) * gl_Color; };"));
}

TEST(NoShim, FactsAreReadAllTheSame) {
    ProgramRequest request = program(
        {{Stage::vertex, kPlainVertex},
         {Stage::geometry,
          "#version 330\nlayout(lines) in; layout(points, max_vertices = 1) out;\nvoid main() { "
          "EmitVertex(); }\n"},
         {Stage::fragment,
          "#version 330\nuniform float u = 1.;\nout vec4 a, b;\nvoid main() { a = b = vec4(u); }\n"}});
    request.shim = false;
    const TranslatedProgram translated = translate(request);
    EXPECT_EQ("lines", translated.geometryInput);
    EXPECT_EQ(2, translated.fragmentOutputs);
    EXPECT_TRUE(translated.uniforms.at("u").hasInitializer);
    EXPECT_FALSE(hasTokens(sourceOf(translated, Stage::fragment), "layout"));
}

}  // namespace
}  // namespace glibra::glsl::test
