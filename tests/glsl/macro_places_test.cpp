// The line map inside macro calls: messages of the driver name what the user wrote.

#include <gtest/gtest.h>

#include <algorithm>

#include "glsl/emit/log.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

struct Emitted {
    int line = 0;
    int column = 0;
};

/// Where the driver sees a word: the line as its #line directives count, and the column.
Emitted seenBy(const TranslatedStage& stage, const std::string& word) {
    Emitted place;
    std::size_t at = 0;
    while (at < stage.source.size()) {
        const std::size_t end = stage.source.find('\n', at);
        const std::string line = stage.source.substr(at, end - at);
        if (line.starts_with("#line ")) {
            place.line = std::stoi(line.substr(6));
        } else {
            const std::size_t found = line.find(word);
            if (found != std::string::npos) return {place.line, static_cast<int>(found) + 1};
            ++place.line;
        }
        at = end + 1;
    }
    return {};
}

/// The messages for an undeclared word, as Mesa (with a column) or NVIDIA (without) gives them.
std::string messagesAbout(const std::string& text, const std::string& word, bool hasColumn = true) {
    const TranslatedProgram translated = translate(program({{Stage::fragment, text}}));
    if (translated.stages.empty()) return "nothing was emitted: " + ids(translated.diagnostics);
    const Emitted place = seenBy(translated.stages[0], word);
    const std::string line = std::to_string(place.line);
    const std::string log =
        hasColumn ? "0:" + line + "(" + std::to_string(place.column) + "): error: `" + word + "' undeclared\n"
                  : "0(" + line + ") : error C1503: undefined variable \"" + word + "\"\n";
    std::string result;
    for (const Diagnostic& each : explainCompileLog(translated, translated.stages[0], log)) {
        if (each.text.starts_with("in Program")) continue;
        if (!result.empty()) result += "; ";
        result += std::to_string(each.place.line) + ":" + std::to_string(each.place.column);
        if (each.severity == Severity::note) result += " " + each.text;
    }
    return result;
}

const std::string kMiddle =
    "#version 120\nvarying vec2 vST;\n#define MIDDLE(a, b) (.5 * ((a) + (b)))\n#define SECOND(a, b) ((b) * "
    "(a) + (b))\n"
    "#define WRONG(a) ((a) * inMacro)\n";

TEST(MacroPlaces, WhatFollowsACallOfSeveralLines) {
    const std::string text =
        kMiddle +
        "void main() {\n    float k = MIDDLE(\n        vST.x,\n        vST.y\n    ), after0 = after1;\n"
        "    gl_FragColor = vec4(k, misspelt, 0., 1.);\n}\n";
    EXPECT_EQ("11:28", messagesAbout(text, "misspelt"));
    EXPECT_EQ("11:28", messagesAbout(text, "misspelt", false));
    EXPECT_EQ("10:17", messagesAbout(text, "after1"));
    EXPECT_EQ("10:17", messagesAbout(text, "after1", false));
}

TEST(MacroPlaces, ArgumentsKeepTheirPlace) {
    // On every line of the call, in macros that keep the order of the arguments and in others.
    for (const std::string macro : {"MIDDLE", "SECOND"})
        for (int line = 0; line < 6; ++line) {
            std::string call = "void main() { float k = " + macro + "(";
            int column = 0;
            for (int i = 0; i < 6; ++i) {
                call += "\n" + std::string(static_cast<std::size_t>(i), ' ') + (i ? "+ " : "");
                if (i == line) column = i + (i ? 3 : 1);
                call += (i == line ? "misspelt" : "vST.x");
                if (i == 2) call += ", 0.";
            }
            EXPECT_EQ(std::to_string(7 + line) + ":" + std::to_string(column),
                      messagesAbout(kMiddle + call + "); gl_FragColor = vec4(k); }\n", "misspelt"))
                << call;
        }
}

TEST(MacroPlaces, ArgumentsInTheLineOfTheCallHaveNoNote) {
    EXPECT_EQ("6:17", messagesAbout(kMiddle + "float f = WRONG(misspelt);\n", "misspelt"));
    EXPECT_EQ("8:11", messagesAbout(kMiddle + "float f = WRONG(\n1.\n) + WRONG(misspelt);\n", "misspelt"));
    EXPECT_EQ("6:21", messagesAbout(kMiddle + "float f = MIDDLE(1.,misspelt);\n", "misspelt"));
}

TEST(MacroPlaces, ArgumentsKeepTheirPlaceWithoutColumns) {
    EXPECT_EQ("8:3", messagesAbout(kMiddle + "void main() { float k = MIDDLE(\n1.,\n  misspelt); }\n",
                                   "misspelt", false));
}

TEST(MacroPlaces, TheTextOfAMacroIsReportedAtTheCallWithANote) {
    EXPECT_EQ("7:8; 5:25 in the text of macro 'WRONG'",
              messagesAbout(kMiddle + "float f() {\n  1. + WRONG(\n 2. ); }", "inMacro"));
    EXPECT_EQ("6:9; 5:25 in the text of macro 'WRONG'",
              messagesAbout(kMiddle + "float f=WRONG(\n 2. );", "inMacro"));
    // Called by another macro: the place is that of the outermost call.
    EXPECT_EQ("7:9; 5:25 in the text of macro 'WRONG'",
              messagesAbout(kMiddle + "#define OUTER(x) (1. + WRONG(x))\nfloat f=OUTER(2.);", "inMacro"));
    // Called in an argument.
    EXPECT_EQ("7:2; 5:25 in the text of macro 'WRONG'",
              messagesAbout(kMiddle + "float f=MIDDLE(1.,\n WRONG(2.));", "inMacro"));
}

TEST(MacroPlaces, AMistakeInACallHasNoConsequences) {
    const TranslatedProgram translated = translate(program(
        {{Stage::fragment, kMiddle + "float f = MIDDLE(\n vST.x,\n misspelt\n);\nvoid main() {}\n"}}));
    const std::string log =
        "0:8(2): error: `misspelt' undeclared\n"
        "0:6(17): error: operands to arithmetic operators must be numeric\n"
        "0:10(1): error: operands to arithmetic operators must be numeric\n";
    const Diagnostics found = explainCompileLog(translated, translated.stages.at(0), log);
    ASSERT_EQ(3U, found.size());  // the note about the program is the last one
    EXPECT_EQ((Place{"a.frag", 8, 2}), found[0].place);
    EXPECT_EQ(10, found[1].place.line);
}

TEST(MacroPlaces, DirectivesInACallKeepTheLines) {
    EXPECT_EQ(
        "11:4",
        messagesAbout(kMiddle + "float f=MIDDLE(1.,\n#ifdef NOTHING\n3.\n#else\n4.\n + misspelt );\n#endif\n",
                      "misspelt"));
    EXPECT_EQ("101:1",
              messagesAbout(kMiddle + "float f=MIDDLE(1.,\n#line 99\n4.);\nmisspelt;\n", "misspelt"));
}

TEST(MacroPlaces, CommentsAndJoinedLinesKeepTheLines) {
    for (const std::string before :
         {"/* a\n b */", "#define J \\\n 3\n", "int a = 1 + \\\n 2;", "// c \\\n",
          "#if 0\n/* x\n\n*/\n#endif", "int ab\\\ncd;", "float m = MIDDLE(1., /* 2\n */ 2.\n // x\n);",
          "#define E /* \n */ 3\n", "float m = MIDDLE( \\\n 1. \\\n, 2.);"}) {
        const std::string text = kMiddle + before + "\n  float f = misspelt;\nvoid main() {}\n";
        const auto line =
            1 +
            std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("misspelt")), '\n');
        EXPECT_EQ(std::to_string(line) + ":13", messagesAbout(text, "misspelt")) << before;
        EXPECT_EQ(std::to_string(line) + ":13", messagesAbout(text, "misspelt", false)) << before;
    }
}

TEST(MacroPlaces, GlslangFindsTheSameLines) {
    for (int lines = 1; lines < 5; ++lines) {
        std::string text = kMiddle + "void main() {\n float k = MIDDLE(1." +
                           std::string(static_cast<std::size_t>(lines), '\n') +
                           ", 2.);\n gl_FragColor = vec4(k * misspelt);\n}\n";
        const std::string output = glslangOutput(translate(program({{Stage::fragment, text}})), "");
        EXPECT_NE(std::string::npos, output.find("0:" + std::to_string(8 + lines) + ": 'misspelt'"))
            << output;
    }
}

}  // namespace
}  // namespace glibra::glsl::test
