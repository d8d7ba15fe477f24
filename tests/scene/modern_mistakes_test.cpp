// Mistakes that no single argument shows: cycles, targets that do not fit together, limits, and errors that
// repeat.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "glib/messages.h"
#include "glib/script.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::idsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

/// The errors of a text, also those of its parser.
std::string errorsOf(std::string_view text) {
    const glib::Script script = glib::parse(text, "scene.glib");
    Diagnostics all = script.diagnostics;
    append(all, interpret(script).diagnostics);
    std::erase_if(all, [](const Diagnostic& each) { return each.severity != Severity::error; });
    return textsOf(all);
}

TEST(Mistakes, GroupsThatDrawEachOther) {
    EXPECT_EQ(
        errorsOf("Group a\nBox\nEndGroup\nGroup b\nDraw a\nEndGroup\nGroup a\nDraw b\nEndGroup\nDraw a\n"),
        "5:1 glib-E28 group 'a' draws itself");
    EXPECT_EQ(errorsOf("Group a\nDraw a\nDraw a\nEndGroup\nDraw a\nDraw a\n"),
              "2:1 glib-E28 group 'a' draws itself\n3:1 glib-E28 group 'a' draws itself");
}

TEST(Mistakes, VariablesThatAreStatedTwice) {
    EXPECT_EQ(errorsOf("Let n 5\nLet n 6\n"),
              "2:5 glib-E36 'n' is declared on line 1 already, as a variable; only if it begins with 'Let n "
              "(expression)' may it be stated again");
    EXPECT_EQ(errorsOf("Let n (5)\nLet n (6)\n"), "");
    EXPECT_EQ(errorsOf("Let n 5\nSampler n nearest\n").find("stated again"), std::string::npos);
}

TEST(Mistakes, UnknownWordsInConditionsNameTheOnesThatFit) {
    EXPECT_EQ(errorsOf("Let h <true>\nState cull (h ? front_and_back : off)\nBox\n"),
              "2:17 expr-E02 unknown name 'front_and_back'; the words here are off, back, front and both");
}

TEST(Mistakes, CamerasThatSeeNothing) {
    const auto warnings = [](const std::string& rest, const std::string& name = "main") {
        return textsOf(
            run("Camera " + name + " LookAt 0 0 5 0 0 0 0 1 0 Perspective 50 1 20\n" + rest).diagnostics);
    };
    EXPECT_EQ(warnings("Sphere\n"),
              "1:1 glib-W38 camera 'main' is not used; the camera 'eye' sees the window");
    EXPECT_EQ(warnings("Let domain 1\nSphere (domain)\n"),
              "1:1 glib-W38 camera 'main' is not used; the camera 'eye' sees the window");
    EXPECT_EQ(warnings("Pass window from main\nSphere\nEndPass\n"), "");
    EXPECT_EQ(warnings("Camera eye Shift main .1 0 0\nSphere\n"), "");
    EXPECT_EQ(warnings("Sphere (main.near)\n"), "");
    EXPECT_EQ(warnings("When (main.near > 0)\nSphere\nEndWhen\n"), "");
    EXPECT_EQ(warnings("Sphere\n", "eye"), "");
    EXPECT_EQ(warnings("Pass window from main[1]\nSphere\nEndPass\n", "main[2]"), "");
}

TEST(Mistakes, FilesThatIncludeEachOther) {
    const TemporaryFolder folder;
    folder.write("a.glib", "Box\nInclude b.glib\n");
    folder.write("b.glib", "Sphere\nInclude c.glib\n");
    folder.write("c.glib", "Cone\nInclude a.glib\n");
    const Scene scene = run("Include a.glib\n", folder.write("scene.glib", ""));
    ASSERT_EQ(idsOf(scene.diagnostics), "glib-E28") << textsOf(scene.diagnostics);
    EXPECT_EQ(std::filesystem::path(scene.diagnostics[0].place.file).filename(), "c.glib");
    EXPECT_EQ(scene.diagnostics[0].place.line, 2);
    EXPECT_EQ(scene.diagnostics[0].text, "'a.glib' includes itself");
    EXPECT_EQ(tests::drawsOf(scene).size(), 3U);
}

TEST(Mistakes, TooManyNestedFiles) {
    const TemporaryFolder folder;
    for (int i = 0; i < 80; ++i)
        folder.write("f" + std::to_string(i) + ".glib", "Include f" + std::to_string(i + 1) + ".glib\n");
    folder.write("f80.glib", "Box\n");
    const Scene scene = run("Include f0.glib\n", folder.write("scene.glib", ""));
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E15");
    EXPECT_NE(textsOf(scene.diagnostics).find("more than 64 nested groups and files"), std::string::npos);
}

constexpr const char* kTargets = R"(Texture2D a 8 8 rgba8
Texture2D wide 16 8 rgba8 levels 2
Texture2D many 8 8 rgba8 samples 4
Texture2DArray layers 8 8 4 rgba8
Texture2D depth 8 8 depth32f
Texture2D depth2 8 8 depth24
Texture1D line 8 rgba8
Texture2D past 8 8 rgba8 history
Texture2D picture a.png
Sampler crisp nearest
Buffer numbers float 4
)";

TEST(Mistakes, TargetsThatDoNotFitTogether) {
    const auto errorOf = [](const std::string& targets) {
        return errorsOf(kTargets + ("Pass " + targets + "\nBox\nEndPass\n"));
    };
    EXPECT_EQ(errorOf("a depth"), "");
    EXPECT_EQ(errorOf("a wide.level(1)"),
              "12:8 glib-E11 Pass: 'a' is 8 x 8, 'wide.level(1)' is 8 x 4; all must have the same size");
    EXPECT_EQ(errorOf("a wide"),
              "12:8 glib-E11 Pass: 'a' is 8 x 8, 'wide' is 16 x 8; all must have the same size");
    EXPECT_EQ(errorOf("a many"), "12:8 glib-E11 Pass: 'a' has 1 sample, 'many' has 4; all must have as many");
    EXPECT_EQ(errorOf("a layers"),
              "12:8 glib-E11 Pass: 'a' has 1 layer, 'layers' has 4; all must have as many");
    EXPECT_EQ(errorOf("a layers.layer(2) depth"), "");
    EXPECT_EQ(errorOf("a depth depth2"),
              "12:14 glib-E11 Pass: 'depth2' is the second depth texture; a pass has one");
    EXPECT_EQ(errorOf("a a"), "12:8 glib-E11 Pass: 'a' is named twice");
    EXPECT_EQ(errorOf("window a"), "12:6 glib-E11 Pass: the window is the only target of its pass");
    EXPECT_EQ(errorOf("line"),
              "12:6 glib-E11 Pass: 'line' is a 1D texture; a target has a width and a height");
    EXPECT_EQ(errorOf("past.prev"), "12:6 glib-E11 Pass: 'past.prev' is only read; draw into 'past'");
    EXPECT_EQ(errorOf("a.crisp"), "12:6 glib-E11 Pass: 'a.crisp': a target is not sampled");
    EXPECT_EQ(errorOf("numbers"), "12:6 glib-E34 'numbers' is not a texture");
    EXPECT_NE(errorOf("picture").find(
                  "12:6 glib-E11 Pass: 'picture' is a picture; a target has a size and a format"),
              std::string::npos);
    EXPECT_EQ(errorOf("layers.layer(4)"), "12:6 glib-E05 layers.layer: 4 is not between 0 and 3");
    EXPECT_EQ(errorOf("wide.level(2)"), "12:16 glib-E05 wide.level: 2 is not between 0 and 1");
    EXPECT_EQ(errorOf("a.face(1)"), "12:6 glib-E35 'a' has no part 'face'; it has level, crisp");
}

TEST(Mistakes, MipmapsOfFormatsThatHaveNone) {
    for (const char* format : {"depth24", "depth32f", "depth24_stencil8", "r32ui"}) {
        const std::string errors =
            errorsOf(std::string("Texture2D a 8 8 ") + format + " nearest_mipmap_nearest generate\n");
        EXPECT_NE(errors.find("has no mipmaps"), std::string::npos) << format << errors;
    }
}

TEST(Mistakes, FormatsThatAreNone) {
    EXPECT_EQ(errorsOf("Texture2D a 8 8 rgb8\n"),
              "1:17 glib-E16 Texture2D: the format 'rgb8' has three components; write 'rgba8'");
    EXPECT_EQ(errorsOf("Texture2D a 8 8 rgba16ff\n"),
              "1:17 glib-E16 Texture2D: unknown format 'rgba16ff'; did you mean 'rgba16f'?");
    EXPECT_EQ(errorsOf("Texture3D a 8 8 8 depth24\n"),
              "1:19 glib-E32 Texture3D: 'depth24' is for 2D textures, arrays and cube maps");
    EXPECT_EQ(errorsOf("Texture2D a 8 8 r32ui linear\n"),
              "1:23 glib-E32 Texture2D: 'r32ui' holds integers, which are read with 'nearest'");
}

TEST(Mistakes, DispatchesWithoutGroups) {
    const std::string program = "Compute inline\nEndCompute\nProgram P\n";
    const char* limits = "is not between 1 and 2,147,483,647";
    for (const char* groups : {"0 1 1", "1 0 1", "2147483648 1 1", "1 1 -3", "(1 - 1) 1 1"}) {
        const std::string errors = errorsOf(program + "Dispatch P " + groups + "\n");
        EXPECT_NE(errors.find(limits), std::string::npos) << groups << ": " << errors;
        EXPECT_EQ(errors.find('\n'), std::string::npos) << errors;
    }
    EXPECT_NE(errorsOf(program + "Dispatch P over 0\n").find(limits), std::string::npos);
    EXPECT_EQ(errorsOf(program + "Dispatch P 2147483647 1 1\n"), "") << "the driver has its own limit";
}

TEST(Mistakes, ExpressionsOfTenThousandLevels) {
    for (const auto& [open, close] : {std::pair("(", ")"), std::pair("-", ""), std::pair("sin(", ")")}) {
        std::string text = "Translate (";
        for (int i = 0; i < 10'000; ++i) text += open;
        text += "pi";
        for (int i = 0; i < 10'000; ++i) text += close;
        const std::string errors = errorsOf(text + ") 0 0\nBox\n");
        EXPECT_TRUE(errors.starts_with("1:")) << errors.substr(0, 200);
        EXPECT_EQ(errors.find('\n'), std::string::npos) << errors.substr(0, 400);
    }
}

TEST(Mistakes, OfARepetitionAreReportedOnce) {
    EXPECT_EQ(errorsOf("Repeat 1000 as k\nInstances (-k - 1)\nBox\nEndRepeat\n"),
              "2:11 glib-E05 Instances: -1 is not between 0 and 100,000,000");
    EXPECT_EQ(
        errorsOf("Group a\nMaterial glod\nBox\nEndGroup\nDraw a\nDraw a\nRepeat 5\nDraw a\nEndRepeat\n"),
        "2:10 glib-E16 no material 'glod'; did you mean 'gold'?");
    EXPECT_EQ(errorsOf("Let a 1\nSet uMap nothing\nBox\nBox\nSphere\n"),
              "2:10 glib-E27 'nothing' is no variable, texture or buffer");
    EXPECT_EQ(errorsOf("Group tree\nBox\nEndGroup\nSet uMap tree\nBox\n"),
              "4:10 glib-E34 'tree' is no variable, texture or buffer");
}

TEST(Mistakes, OfADeclarationAreNotThoseOfItsUses) {
    EXPECT_EQ(errorsOf("Texture2D shadow 8 8 depth32f linar\nPass shadow\nBox (shadow.size.x)\nEndPass\n"
                       "Set uMap shadow\nBox\nExpect finite shadow\n"),
              "1:31 glib-E16 Texture2D: unknown word 'linar'; did you mean 'linear'?");
    EXPECT_EQ(errorsOf("Let a (b)\nLet c (a + 1)\nLet d[3] (c)\nBox (d[1])\n"),
              "1:8 expr-E02 unknown name 'b'");
    EXPECT_EQ(errorsOf("Compute\nProgram P\nDispatch P 1 1 1\n"),
              "1:1 glib-E17 Compute: expected 'inline' or a file (file), found the end of the statement");
    EXPECT_EQ(errorsOf("Group a 5\nBox\nEndGroup\nDraw a\n"), "1:9 glib-E18 Group: surplus argument '5'");
    const TemporaryFolder folder;
    folder.write("part.glib", "Camera low LookAt 0 0 5\nBuffer b float 0\n");
    const Scene scene = run("Include part.glib\nPass window from low\nBox (b.count)\nEndPass\n",
                            folder.write("scene.glib", ""));
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E17 glib-E05") << textsOf(scene.diagnostics);
    // A name that nothing declares is reported all the same.
    EXPECT_EQ(errorsOf("Let a (1 / 0)\nBox (a)\nBox (e)\n"),
              "1:8 expr-E06 '1 / 0': division by zero\n3:6 expr-E02 unknown name 'e'");
}

TEST(Mistakes, AVariableWithoutAValueForAMomentHasOneLater) {
    Interpretation script(glib::parse("Let a (1 / time)\nTranslate (a) 0 0\nBox\n", "scene.glib"), {});
    const Scene first = script.at({.time = 0});
    EXPECT_EQ(idsOf(first.diagnostics), "expr-E06") << textsOf(first.diagnostics);
    const Scene second = script.at({.time = .5});
    EXPECT_EQ(textsOf(second.diagnostics), "");
    EXPECT_EQ(tests::drawsOf(second).at(0).modelView[3].x, 2);
}

TEST(Mistakes, OfTheTextAreReportedWhicheverRunOfAFrameFindsThem) {
    const std::string text =
        "Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\nLet arr[5] (i*i)\n"
        "Let shift (eye.prev.position.x)\nLet f(x) (x + arr[9])\nWhen (time > 1)\nBox (arr[7])\n"
        "Box (nothing)\nEndWhen\nTranslate (arr[6]) 0 0\nBox\n";
    Interpretation script(glib::parse(text, "scene.glib"), {});
    EXPECT_EQ(textsOf(script.at({.time = 0}).diagnostics),
              "4:19 expr-E06 subscript 9 is not between 0 and 4\n"
              "9:16 expr-E06 subscript 6 is not between 0 and 4");
    EXPECT_EQ(textsOf(script.at({.time = 2}).diagnostics),
              "6:10 expr-E06 subscript 7 is not between 0 and 4\n7:6 expr-E02 unknown name 'nothing'")
        << "the run of the frame before meets them first";
    EXPECT_EQ(textsOf(script.at({.time = 3}).diagnostics), "") << "each time once";
}

TEST(Mistakes, OfWhatDoesNotRunAreFoundWithoutItsValues) {
    const auto leftOut = [](const std::string& text) {
        Interpretation script(glib::parse(text, "scene.glib"), {});
        EXPECT_EQ(textsOf(script.at({}).diagnostics), "");
        return textsOf(script.mistakesLeftOut({}));
    };
    EXPECT_EQ(
        leftOut("Let k <0 1 2>\nWhen (k == 0)\n Box (vec2(1) * vec3(2))\n Use Nope\nElse\n Box\n"
                "EndWhen\nGroup g a 1\n Box (a.foo)\nEndGroup\nRepeat (k - 1)\n Box (nope)\nEndRepeat\n"),
        "3:7 expr-E03 '*' does not combine vec2 and vec3\n4:6 glib-E27 no program 'Nope' is declared "
        "before this line\n9:9 expr-E02 a number has no component or field 'foo'\n"
        "12:7 expr-E02 unknown name 'nope'");
    EXPECT_EQ(leftOut("Let k <0 1 2>\nLet a[3] (i)\nWhen (k == 0)\n Let v (1 / k)\n Box (a[4 - k])\nElse\n"
                      " Let v (2)\nEndWhen\nBox (v)\n"),
              "")
        << "of values";
    EXPECT_EQ(leftOut("Group g kind 0 v 1\n When (kind == 0)\n  Box (v)\n Else\n  Box (v.x)\n EndWhen\n"
                      "EndGroup\nDraw g\nDraw g kind 1 v (vec2(1))\n"),
              "")
        << "a parameter decides of which type another one is";
    EXPECT_EQ(
        leftOut("Let k <0 1 2>\nWhen (k == 0)\n Let v (vec2(1))\n Box (v.y)\nElse\n Let v (2)\n Box (v)\n"
                "EndWhen\n"),
        "")
        << "a variable has another type in each branch";
}

TEST(Mistakes, OfNamesThatAreNoValuesSayWhatToWrite) {
    const std::string buffers = "Buffer b vec4 8 (vec4(i))\nBuffer p Part 8\n";
    const std::string of =
        "expr-E08 'b' is a buffer, not a value; write b.count, or in Expect (...) and Print (...) b[0] or "
        "sum(b)";
    EXPECT_EQ(errorsOf(buffers + "Print (b)\n"), "3:8 " + of);
    EXPECT_EQ(errorsOf(buffers + "Let q (b)\n"), "3:8 " + of);
    EXPECT_NE(errorsOf(buffers + "Print (p[1].mass)\n").find("and Print (...) sum(p.MEMBER)"),
              std::string::npos)
        << errorsOf(buffers + "Print (p[1].mass)\n");
    EXPECT_EQ(errorsOf("Texture2D glow 8 8 rgba8\nLet k 3\nGroup gg target glow\n Pass target\n EndPass\n"
                       "EndGroup\nDraw gg\nDraw gg target k\n"),
              "4:7 glib-E34 'target' has a value here, and is no texture or buffer");
}

TEST(Choices, TakeTheWholeNumbersOfTheirWords) {
    const auto idsWith = [](double value) {
        Interpretation script(glib::parse("Let ch <one two three>\nBox (ch + 1)\n", "scene.glib"), {});
        FrameInputs inputs;
        inputs.variables["ch"] = {value};
        return idsOf(script.at(inputs).diagnostics);
    };
    EXPECT_EQ(idsWith(2), "");
    EXPECT_EQ(idsWith(1.5), "glib-E05");
    EXPECT_EQ(idsWith(3), "glib-E05");
    EXPECT_EQ(errorsOf("Let ch <one two three>\nKey k ch 1.5\n"),
              "2:10 glib-E05 Key: 1.5 is not a whole number between 0 and 2, which 'ch' allows");
    const Scene scene = run("Let ch <one two three>\nKey k ch 2\nKey l ch (ch + 5)\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    EXPECT_EQ(scene.keys.at(1).values.at(0), std::vector<double>{2}) << "as at the end of a slider";
}

TEST(Variables, ThatAreListsCanBeSet) {
    Interpretation script(
        glib::parse("Let tint [1 1 1]\nLet row [1 2 3 4 5]\nTranslate (tint)\nTranslate (row[4]) 0 0\nBox\n",
                    "scene.glib"),
        {});
    FrameInputs inputs;
    inputs.variables["tint"] = {3, 1, 2};
    inputs.variables["row"] = {0, 0, 0, 0, 7};
    const Scene scene = script.at(inputs);
    EXPECT_EQ(tests::placeOf(tests::drawsOf(scene).at(0)), glm::dvec3(10, 1, 2));
    EXPECT_EQ(scene.usedVariables.at("tint"), 3U);
    inputs.variables["tint"] = {3, 1};
    EXPECT_EQ(tests::placeOf(tests::drawsOf(script.at(inputs)).at(0)), glm::dvec3(8, 1, 1));
}

TEST(Mistakes, OfTheLaterElementsOfABufferAreReportedWhenTheyAreRead) {
    const Scene scene = tests::run("Buffer b float 4 (1/(2 - i))\nBuffer c int 2 (i + .5)\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    ASSERT_EQ(scene.buffers.size(), 2U);
    const BufferValues copy = scene.buffers.at(0).values;
    EXPECT_EQ(copy.size(), 4U);
    EXPECT_TRUE(scene.buffers.at(0).values.hasFailed());
    EXPECT_EQ(copy.numbers(), (std::vector<double>{.5, 1, 0, 0}));
    EXPECT_EQ(idsOf(copy.takeProblems()), "expr-E06");
    EXPECT_EQ(idsOf(scene.buffers.at(0).values.takeProblems()), "expr-E06")
        << "it has no values later either";
    EXPECT_EQ(textsOf(scene.buffers.at(1).values.takeProblems()), "2:16 glib-W27 0.5 is cut to 0");
    EXPECT_EQ(textsOf(scene.buffers.at(1).values.takeProblems()), "") << "reported twice";
    EXPECT_TRUE(copy == scene.buffers.at(0).values);
    EXPECT_FALSE(tests::run("Buffer b float 2 (0/(1 - i))\n").buffers.at(0).values ==
                 tests::run("Buffer b float 2 (0*i)\n").buffers.at(0).values)
        << "what has no values equals no zeros";
    const Scene timed = tests::run("Let k (time)\nBuffer b int 4 (i + k + .5)\n");
    EXPECT_EQ(textsOf(timed.buffers.at(0).values.takeProblems()), "") << "time has fractions";
    EXPECT_EQ(errorsOf("Buffer b float 4 (1/i)\n").substr(0, 4), "1:19") << "the first one at once";
}

TEST(Mistakes, OfAVariableAreNotRepeatedByItsChecks) {
    EXPECT_EQ(errorsOf("Let v (1 - sqrt(0 - 1))\nExpect (v == 1)\nBox\n"),
              "1:12 expr-E06 'sqrt(0 - 1)': the result is not a number");
}

TEST(Counts, OfExpressionsAreTheWholeNumbersThatRoundingErrorsMissed) {
    const Scene scene = tests::run(
        "Let steps (.6/.1)\nBuffer b float (.6/.1)\nBuffer c float [(.7/.1) of (i)]\nTexture2D t (.7/.1) "
        "(.29*100) "
        "rgba8\nTexture2DArray a 2 2 (.6/.1) rgba8\nRepeat (.29*100) as k\n    Sphere 1 (.6/.1) (steps)\n"
        "EndRepeat\nInstances (.6/.1)\nVertices points (.29*100)\n");
    EXPECT_EQ(tests::textsOf(scene.diagnostics), "");
    EXPECT_EQ(scene.buffers[*scene.buffers.indices().begin()].count, 6U);
    int sizes = 0;
    for (const Texture& each : scene.textures) {
        if (each.name != "t") continue;
        ++sizes;
        EXPECT_EQ(std::get<EmptySource>(each.source).width, 7);
        EXPECT_EQ(std::get<EmptySource>(each.source).height, 29);
    }
    EXPECT_EQ(sizes, 1);
    const std::vector<Draw> draws = tests::drawsOf(scene);
    ASSERT_EQ(draws.size(), 30U);
    EXPECT_EQ(scene.shapes[draws.front().shape].numbers.at(1), 6);
    EXPECT_EQ(draws.back().instances, 6);
    EXPECT_EQ(scene.shapes[draws.back().shape].numbers.front(), 29);
}

TEST(Counts, ThatAreCutAreReportedOnceForLiteralsAndExpressions) {
    for (const char* text :
         {"Repeat 2.5\nSphere 1\nEndRepeat\n", "Repeat (2.5)\nSphere 1\nEndRepeat\n",
          "Let n 2.5\nRepeat (n)\nSphere 1\nEndRepeat\n", "Buffer b float 2.5\n", "Buffer b float (5/2)\n",
          "Texture2D t 2.5 2 rgba8\n", "Texture2D t (5/2) 2 rgba8\n", "Instances 2.5\nSphere 1\n",
          "Instances (5/2)\nSphere 1\n", "Vertices points 2.5\n", "Vertices points (5/2)\n",
          "Let a[(5/2)] (i)\n", "Repeat 9\nSphere 1 (9/2)\nEndRepeat\n"})
        EXPECT_EQ(tests::idsOf(tests::run(text).diagnostics), "glib-W27") << text;
    // What follows the window or the time is cut on purpose.
    EXPECT_EQ(
        tests::idsOf(tests::run("Texture2D t (window.x/7) (window.y/7) rgba8\nRepeat (2.5 + time)\nSphere 1 "
                                "(7.5 + time)\nEndRepeat\n")
                         .diagnostics),
        "");
}

TEST(Floats, ThatNoFloatHoldsAreReportedWhereTheyAreStored) {
    for (const char* text :
         {"Pass window clear {(1e39) 0 0}\nEndPass\n", "Attribute a (1e39)\nSphere 1\n",
          "TessLevels (1e39) 1 1 1 1 1\nSphere 1\n", "Light 0 position (vec3(1e39))\nSphere 1\n",
          "Light 0 position 1e39 0 0\nSphere 1\n", "State blendcolor (1e39) 0 0 0\nSphere 1\n",
          "Camera eye LookAt 0 0 (1e39) 0 0 0 0 1 0 Perspective 50 .1 100\nSphere 1\n",
          "Camera eye (2*mat4(1e39)) (mat4(1))\nSphere 1\n", "Let c {(1e39) 0 0}\n",
          "Translate (2*1e39) 0 0\nBox 1\n", "Background (2*1e39) 0 0\nLet x 1\n"})
        EXPECT_NE(tests::idsOf(tests::run(text).diagnostics).find("glib-E31"), std::string::npos) << text;
    EXPECT_EQ(tests::textsOf(tests::run("Let x (1e300)\nLet y 1e300\nBuffer b double [1e300]\n").diagnostics),
              "");
    Interpretation script = tests::scriptOf("Let x 1\nTranslate (pow(10, time)) 0 0\nBox 1\n");
    EXPECT_EQ(tests::idsOf(tests::sceneAt(script, 38).diagnostics), "");
    EXPECT_EQ(tests::idsOf(tests::sceneAt(script, 39).diagnostics), "glib-E31");
}

/// What the catalogue shows for an id is what a scene with that mistake says.
TEST(Catalogue, ExamplesOfTheInterpreterAreItsMessages) {
    const std::string camera = "Camera c LookAt ";
    for (const auto& [id, text] : std::vector<std::pair<const char*, std::string>>{
             {"glib-E13", "LookAt 1 1 1 1 1 1 0 1 0\nSphere\n"},
             {"glib-E25", "Once\nSphere\nEndOnce\n"},
             {"glib-E26", camera + "(vec4(0, 0, 5, 0)) (vec4(0, 0, 0, 1)) Perspective 50 1 10\n"},
             {"glib-E27", "Group tree\nBox\nEndGroup\nDraw tre\n"},
             {"glib-E28", "Group tree\nDraw tree\nEndGroup\nDraw tree\n"},
             {"glib-E29", camera + "0 0 5 0 0 0 0 1 0 Perspective 50 10 1\n"},
             {"glib-E32", "Texture2D a 4 4 rgba8 flip\n"},
             {"glib-E33", "Repeat [1 (vec3(1, 2, 3))]\nBox\nEndRepeat\n"},
             {"glib-E34", "Texture2D sky 4 4 rgba8\nInstances from sky\nBox\n"},
             {"glib-E35", "Texture2D glow 4 4 rgba8\nPass glow.levle(0)\nEndPass\n"},
             {"glib-E36", "Texture2D a 4 4 rgba8\nBuffer a float 4\n"},
             {"glib-E38",
              "Texture2D a 4 4 rgba8\nTexture2D d 4 4 depth24\nPass a d\nClear stencil\nEndPass\n"},
             {"expr-E08", "Let a[3] (i)\nBox (a)\n"}}) {
        const Diagnostics found = run(text).diagnostics;
        const auto message = std::ranges::find(found, id, &Diagnostic::id);
        ASSERT_NE(message, found.end()) << id << ": " << textsOf(found);
        EXPECT_EQ(message->text, glib::findDiagnostic(id)->example) << id;
    }
}

/// One id has one meaning: the same mistake in other statements, and another mistake in the same one.
TEST(Messages, HaveTheIdOfTheirMeaning) {
    const std::string texture = "Texture2D a 4 4 rgba8 levels 2\nBuffer b float 4\n";
    for (const auto& [id, text] : std::vector<std::pair<const char*, std::string>>{
             {"glib-E05", "Fps 0\n"},
             {"glib-E05", "Step (0)\nEndStep\n"},
             {"glib-E05", "Buffer c float 0\n"},
             {"glib-E05", texture + "Pass a.level(9)\nEndPass\n"},
             {"glib-E05", "State depthrange 0 2\nBox\n"},
             {"glib-E05", "Texture2D c 4 4 rgba8 levels 9\n"},
             {"glib-E15", "Repeat 1000000000\nBox\nEndRepeat\n"},
             {"glib-E16", "Let x 1\nMaterial glod\nBox\n"},
             {"glib-E16", "Mesh m Spher\n"},
             {"glib-E16", "Let v <red green>\nKey k v blue\n"},
             {"glib-E16", "Attribute a as colour\nBox\n"},
             {"glib-E26", "Light 0 position 0 1\nBox\n"},
             {"glib-E26", "Buffer c vec3 2 [1 2 3 4]\n"},
             {"glib-E29", "Bound n <4 4 4>\n"},
             {"glib-E29", "Expect count [1 0 0] 5 1\n"},
             {"glib-E29", texture + "Print b 3 1\n"},
             {"glib-E32", "Mesh m Obj\n"},
             {"glib-E32", "Vertices quads 4\n"},
             {"glib-E34", texture + "Expect same a b\n"},
             {"glib-E34", texture + "Camera c[2] LookAt (i) 0 5 0 0 0 0 1 0 Ortho -1 1 -1 1 1 9\nPass a from "
                                    "c\nEndPass\n"},
             {"glib-E35", "Texture2DArray c 4 4 2 rgba8\nPass c.layer\nEndPass\n"},
             {"glib-E36", "Buffer window float 4\n"}})
        EXPECT_EQ(idsOf(run(text).diagnostics), id) << text;
}

}  // namespace
}  // namespace glibra::scene
