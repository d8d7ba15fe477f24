// Logs of drivers, exactly as they write them (language, 7.12).

#include <gtest/gtest.h>

#include "glsl/emit/log.h"
#include "glsl/emit/log_line.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// A program whose fragment stage has two files, a built-in name and a renamed one.
TranslatedProgram sample() {
    ProgramRequest request = program({{Stage::vertex, kPlainVertex},
                                      {Stage::fragment,
                                       "#version 120\n#include \"lib.glsl\"\nuniform float sample;\nvoid "
                                       "main() {\n\tgl_FragColor = gl_Color * nothing;\n}\n"}});
    request.include = [](std::string_view, std::string_view) {
        return IncludedFile{"dir/lib.glsl", "float a;\nfloat b;\n"};
    };
    return translate(request);
}

Diagnostics explain(std::string_view log) {
    const TranslatedProgram translated = sample();
    return explainCompileLog(translated, translated.stages.at(1), log);
}

std::string first(std::string_view log) {
    return toString(explain(log).at(0));
}

TEST(CompileLog, Mesa) {
    EXPECT_EQ("a.frag:5:28: error: `nothing' undeclared [glsl-E01]",
              first("0:5(41): error: `nothing' undeclared\n"));
    EXPECT_TRUE(explain("0:3(1): warning: unused\n").empty());
    EXPECT_EQ("dir/lib.glsl:2:1: error: oops [glsl-E01]", first("1:2(1): error: oops\n"));
    EXPECT_EQ("a.frag:4:1: error: Illegal non-directive after # [glsl-E01]",
              first("0:4(1): preprocessor error: Illegal non-directive after #\n"));
    EXPECT_EQ("a.frag:4:1: error: cannot find it [glsl-E01]",
              first("0:4(1): preprocessor error: #error cannot find it\n"));
    EXPECT_EQ("a.frag:4:1: error: #error [glsl-E01]", first("0:4(1): preprocessor error: #error\n"));
}

TEST(CompileLog, NamesTheFileOfAnErrorLineWhateverMesaCallsIt) {
    ProgramRequest request =
        program({{Stage::vertex, kPlainVertex},
                 {Stage::fragment,
                  "#version 120\n#include \"a.glsl\"\n#include \"b.glsl\"\nvoid main() {}\n"
                  "#error own\n"}});
    request.include = [](std::string_view name, std::string_view) {
        if (name != "a.glsl" && name != "b.glsl") return std::optional<IncludedFile>();
        return std::optional(IncludedFile{std::string(name), "// text\n#include \"gone.glsl\"\n"});
    };
    const TranslatedProgram translated = translate(request);
    const std::string missing =
        "0:2(1): preprocessor error: #error cannot find the included file 'gone.glsl'\n";
    std::string places;
    for (const Diagnostic& each :
         explainCompileLog(translated, translated.stages.at(1),
                           missing + missing + "0:5(1): preprocessor error: #error own\n"))
        if (each.severity == Severity::error)
            places += each.place.file + ":" + std::to_string(each.place.line) + " ";
    EXPECT_EQ(places, "a.glsl:2 b.glsl:2 a.frag:5 ");
}

TEST(CompileLog, WordsOfOtherStagesCountInCodeAlone) {
    for (const std::string comment : {"// like gl_TessCoord\n", "/* EmitVertex() */\n"}) {
        const TranslatedProgram translated =
            translate(program({{Stage::vertex, kPlainVertex},
                               {Stage::fragment, "#version 330\n" + comment + "void main() { wrong; }\n"}}));
        const Diagnostics found =
            explainCompileLog(translated, translated.stages.at(1), "0:3(15): error: `wrong' undeclared\n");
        EXPECT_EQ("a.frag:3:15: error: `wrong' undeclared [glsl-E01]", toString(found.at(0))) << comment;
    }
}

TEST(CompileLog, MesaWithNames) {
    EXPECT_EQ("dir/lib.glsl:2:1: error: oops [glsl-E01]", first("\"1\":2(1): error: oops\n"));
    EXPECT_EQ("dir/lib.glsl:2:1: error: oops [glsl-E01]", first("\"dir/lib.glsl\":2(1): error: oops\n"));
}

TEST(CompileLog, Nvidia) {
    EXPECT_EQ("a.frag:5:28: error: undefined variable \"nothing\" [glsl-E01]",
              first("0(5) : error C1008: undefined variable \"nothing\"\n"));
    EXPECT_EQ("dir/lib.glsl:2:1: error: syntax error, unexpected ';' [glsl-E01]",
              first("1(2) : error C0000: syntax error, unexpected ';'\n"));
    EXPECT_TRUE(explain("0(4) : warning C7050: \"x\" might be used before being initialized\n").empty());
}

TEST(CompileLog, AmdAndApple) {
    EXPECT_EQ("a.frag:5:28: error: Use of undeclared identifier 'nothing' [glsl-E01]",
              first("ERROR: 0:5: Use of undeclared identifier 'nothing'\n"));
    EXPECT_EQ(
        "a.frag:5:1: error: Undeclared identifier: nothing [glsl-E01]",
        first(
            "Fragment shader failed to compile with the following errors:\nERROR: 0:5: error(#143) "
            "Undeclared identifier: nothing\nERROR: error(#273) 1 compilation errors.  No code generated\n"));
    EXPECT_TRUE(explain("WARNING: 0:4: Overflow\n").empty());
}

TEST(CompileLog, Glslang) {
    EXPECT_EQ("a.frag:5:28: error: 'nothing' : undeclared identifier [glsl-E01]",
              first("t.frag\nERROR: a.frag:5: 'nothing' : undeclared identifier \nERROR: 1 compilation "
                    "errors.  No code generated.\n\n"));
    EXPECT_EQ("dir/lib.glsl:1:1: error: '' : syntax error [glsl-E01]",
              first("ERROR: dir/lib.glsl:1: '' : syntax error\n"));
}

TEST(CompileLog, EmittedNamesAreTheUsers) {
    EXPECT_EQ("type mismatch of gl_Color, sample and gl_FragColor in main",
              explain("0:5(1): error: type mismatch of glibra_Color, glibra_sample and glibra_FragColor in "
                      "glibra_main\n")
                  .at(0)
                  .text);
}

TEST(CompileLog, LinesOfTheTranslatorAreHidden) {
    EXPECT_TRUE(explain("0:100000003(5): warning: `glibra_noise' is odd\n").empty());
}

TEST(CompileLog, WarningsBesideTextAreNoErrors) {
    EXPECT_TRUE(explain("Compiling done.\n0:3(1): warning: unused\n").empty());
}

TEST(CompileLog, NoteNamesTheProgramOnce) {
    const Diagnostics found = explain("0:5(1): error: a\n0:5(2): error: b\n");
    ASSERT_EQ(3U, found.size());
    EXPECT_EQ("test.glib:7:1: note: in Program 'Test' [glsl-E01]", toString(found[2]));
}

TEST(CompileLog, TextWithoutAPlaceIsKept) {
    const Diagnostics found = explain("Internal compiler error\n");
    EXPECT_EQ("a.frag:1:1: error: Internal compiler error [glsl-E01]", toString(found.at(0)));
    EXPECT_TRUE(explain("").empty());
    EXPECT_TRUE(explain("\n\n").empty());
}

TEST(CompileLog, LineAfterTheEndIsTheLastOne) {
    EXPECT_EQ(6, explain("0:9(1): error: syntax error, unexpected end of file\n").at(0).place.line);
}

TEST(CompileLog, ColumnsFollowTheEdits) {
    // Mesa counts a run of blanks as one. The names before the column are longer in the emitted text.
    const TranslatedProgram translated = translateSingle(
        Stage::fragment, "#version 120\nvoid main() {    gl_FragColor   = /* c */ gl_FragCoord + other; }\n");
    const Diagnostics found =
        explainCompileLog(translated, translated.stages.at(0), "0:2(51): error: `other' undeclared\n");
    EXPECT_EQ(58, found.at(0).place.column);
    const Diagnostics blind =
        explainCompileLog(translated, translated.stages.at(0), "0:2(15): error: something\n");
    EXPECT_EQ(18, blind.at(0).place.column);
}

TEST(LinkLog, MesaNamesAreFound) {
    const TranslatedProgram translated = translateStages(
        {{Stage::vertex, "#version 330\nuniform vec4 c; void main() { gl_Position = c; }\n"},
         {Stage::fragment, "#version 330\nuniform vec3 c; out vec4 o;\nvoid main() { o.xyz = c; }\n"}});
    const Diagnostics found = explainLinkLog(
        translated, "error: uniform `c' declared as type `vec3' and type `vec4'\n", {"s.glib", 9, 1});
    EXPECT_EQ(
        "s.glib:9:1: error: uniform `c' declared as type `vec3' and type `vec4' (a.vert:2, a.frag:2) "
        "[glsl-E02]",
        toString(found.at(0)));
}

TEST(LinkLog, NvidiaSectionsNameTheStage) {
    const Diagnostics found = explainLinkLog(
        sample(), "Fragment info\n-------------\n0(5) : error C1008: undefined variable \"nothing\"\n",
        {"s.glib", 9, 1});
    EXPECT_EQ("a.frag:5:1: error: undefined variable \"nothing\" [glsl-E02]", toString(found.at(0)));
}

TEST(LinkLog, WarningsAreLeftOut) {
    const Diagnostics found =
        explainLinkLog(sample(), "warning: unused varying\nerror: varying `v' differs\n", {"s.glib", 9, 1});
    ASSERT_EQ(1U, found.size());
    EXPECT_EQ("error: varying `v' differs [glsl-E02]", toString(found[0]).substr(12));
}

TEST(LinkLog, EmptyLogIsStillAnError) {
    EXPECT_EQ(1U, explainLinkLog(sample(), "", {"s.glib", 9, 1}).size());
}

TEST(LogLine, FileNamesMayHaveColonsAndBlanks) {
    const std::vector<std::string> files = {"C:/my shaders/a.frag"};
    EXPECT_EQ(12, parseLogLine("ERROR: C:/my shaders/a.frag:12: 'x' : oops", files)->line);
    EXPECT_EQ(12, parseLogLine("C:/my shaders/a.frag(12) : error C0000: oops", files)->line);
    EXPECT_FALSE(parseLogLine("the value of a:12 is odd", files).has_value());
    EXPECT_FALSE(parseLogLine("", files).has_value());
    EXPECT_FALSE(parseLogLine("0:", files).has_value());
    EXPECT_FALSE(parseLogLine("0:5(", files).has_value());
    EXPECT_FALSE(parseLogLine("ERROR: 0:99999999999999: x", files).has_value());
}

}  // namespace
}  // namespace glibra::glsl::test
