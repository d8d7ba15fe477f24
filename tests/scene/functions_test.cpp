// Functions of one's own in expressions (language, 1.8): `Let name(parameters) (body)`.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "glib/script.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

/// The first number of each shape that is drawn, of a scene without messages: `QuadXY (k) 1` shows k.
std::vector<double> shownWith(const std::string& text) {
    const Scene scene = run(text);
    EXPECT_EQ(textsOf(scene.diagnostics), "") << text;
    std::vector<double> shown;
    for (const Draw& each : drawsOf(scene)) shown.push_back(scene.shapes[each.shape].numbers.at(0));
    return shown;
}

/// The errors of a text, also those of its parser.
std::string mistakesOf(std::string_view text) {
    const glib::Script script = glib::parse(text, "scene.glib");
    Diagnostics all = script.diagnostics;
    append(all, interpret(script).diagnostics);
    std::erase_if(all, [](const Diagnostic& each) { return each.severity != Severity::error; });
    return textsOf(all);
}

using Values = std::vector<double>;

TEST(Functions, GiveWhatTheirBodyGives) {
    EXPECT_EQ(shownWith("Let k 3\nLet wave(x t) (k * x + t * t)\nQuadXY (wave(2, 5)) 1\n"), Values{31});
    EXPECT_EQ(shownWith("Let f(x, y) (x - y)\nLet g(x) (f(x * 2, 1) + f(1, x))\nQuadXY (g(4) * 2) 1\n"),
              Values{8});
    EXPECT_EQ(shownWith("Let two() (1 + 1)\nQuadXY (two() * two()) 1\n"), Values{4});
    // Arguments that are computed and constant ones, in both orders, below other values on the stack.
    EXPECT_EQ(shownWith("Let f(x y z) (100 * x + 10 * y + z)\n"
                        "Repeat 2 as i\nQuadXY (1000 + f(i, 2, i + 3) - f(1, i, 0)) 1\nEndRepeat\n"),
              (Values{1000 + 23 - 100, 1000 + 124 - 110}));
    // Only the branch that is chosen is computed.
    EXPECT_EQ(shownWith("Let f(x) (x > 0 ? 1 / x : 7)\nRepeat 2 as i\nQuadXY (f(i)) 1\nEndRepeat\n"),
              (Values{7, 1}));
    EXPECT_EQ(shownWith("Let f(x) (x == 2 || 1 / (x - 2) < 0)\nQuadXY (f(2) && f(1) ? 5 : 6) 1\n"),
              Values{5});
}

TEST(Functions, TakeValuesOfAllTypes) {
    EXPECT_EQ(shownWith("Let times(a b) (a * b)\n"
                        "QuadXY (times(scale(2, 3, 4), vec4(1, 1, 1, 1)).z) 1\n"
                        "QuadXY (times(2, vec2(1, 7)).y) 1\nQuadXY (times(mat2(2), mat2(3))[1][1]) 1\n"),
              (Values{4, 14, 6}));
    EXPECT_EQ(shownWith("Let second(v) (v.y + v[1])\nRepeat 1 as i\nQuadXY (second(vec3(i, i + 4, 0))) 1\n"
                        "EndRepeat\n"),
              Values{8});
    EXPECT_EQ(shownWith("Let pick(c a b) (c ? a : b)\nQuadXY (pick(1 < 2, 3, 4) + pick(false, 3, 4)) 1\n"),
              Values{7});
}

TEST(Functions, NamesInTheBodyAreThoseOfItsPlace) {
    // The counter k of the caller does not hide the variable, and the parameter hides both.
    EXPECT_EQ(
        shownWith("Let k (10)\nLet f(x) (x + k)\nRepeat 2 as k\nQuadXY (f(k) + 100 * k) 1\nEndRepeat\n"),
        (Values{10, 111}));
    EXPECT_EQ(shownWith("Let k (10)\nLet f(k) (k)\nQuadXY (f(3)) 1\n"), Values{3});
    // The value is that of the call.
    EXPECT_EQ(shownWith("Let k (1)\nLet f(x) (x + k)\nQuadXY (f(0)) 1\nLet k (2)\nQuadXY (f(0)) 1\n"),
              (Values{1, 2}));
    EXPECT_EQ(shownWith("Let f(x) (x + model[3][0])\nTranslate 5 0 0\nQuadXY (f(1)) 1\n"), Values{6});
    EXPECT_EQ(shownWith("Let f(x) (2 * x)\nGroup g v 1\nQuadXY (f(v)) 1\nEndGroup\nDraw g v 4\nDraw g\n"),
              (Values{8, 2}));
    // A counter of the name of a function hides it.
    EXPECT_EQ(mistakesOf("Let f(x) (x)\nRepeat 2 as f\nQuadXY (f(1)) 1\nEndRepeat\n"),
              "3:9 expr-E08 'f' is a value, not a function; write '*' to multiply");
}

TEST(Functions, StandWhereverExpressionsDo) {
    EXPECT_EQ(shownWith("Let f(x) (x * x)\nLet a[4] (i == 0 ? 1 : a[i - 1] + f(i))\nWhen (f(2) == 4)\n"
                        "QuadXY (a[3]) 1\nEndWhen\nLet b [3 of (f(i))]\nQuadXY (b[2]) 1\n"),
              (Values{15, 4}));
    const Scene scene = run("Let f(x) (x * .5)\nBuffer b float 100 (f(i))\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    EXPECT_EQ(scene.buffers.begin()->values.numbers().at(99), 49.5);
}

TEST(Functions, FollowTheTimeThatTheyRead) {
    Interpretation script = tests::scriptOf("Let f(x) (x + time)\nQuadXY (f(1)) 1\n");
    for (const double time : {0., 2.}) {
        const Scene scene = tests::sceneAt(script, time);
        EXPECT_EQ(scene.shapes[drawsOf(scene)[0].shape].numbers[0], 1 + time);
    }
}

TEST(Functions, OfAFileThatIsIncludedTwiceAreOne) {
    const TemporaryFolder folder;
    folder.write("f.glib", "Let f(x) (x + 1)\n");
    const Scene scene =
        run("Include f.glib\nInclude f.glib\nQuadXY (f(1)) 1\n", folder.path() / "scene.glib");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    EXPECT_EQ(scene.functions.size(), 1U);
}

TEST(Functions, MistakesInABodyAreReportedWhereItStands) {
    EXPECT_EQ(mistakesOf("Let f(x) (x +)\nSphere (f(1))\nSphere (f(2))\n"),
              "1:14 expr-E01 expected a value, found the end of the expression");
    EXPECT_EQ(mistakesOf("Let f(radius) (radus)\nSphere (f(1))\n"),
              "1:16 expr-E02 unknown name 'radus'; did you mean 'radius'?");
    EXPECT_EQ(mistakesOf("Let f(x) (x + later)\nLet later (3)\nSphere (f(1))\n"),
              "1:15 expr-E02 unknown name 'later'; line 2 sets it, which is below");
    EXPECT_EQ(mistakesOf("Let f(x) (g(x))\nLet g(x) (x)\nSphere (f(1))\n"),
              "1:11 expr-E02 unknown function 'g'; line 2 sets it, which is below");
    EXPECT_EQ(mistakesOf("Let f(x) (f(x - 1))\nSphere (f(1))\n"),
              "1:11 expr-E09 'f' calls itself; a function cannot, but the elements of an array may read "
              "earlier ones");
    EXPECT_EQ(mistakesOf("Let f(x) (x.y + f(x))\nSphere (f(vec2(1)))\n"),
              "2:9 expr-E09 'f(vec2(1))': 'f' calls itself; a function cannot, but the elements of an array "
              "may read earlier ones (line 1, column 17)");
}

TEST(Functions, MistakesOfACallNameThePlaceInTheBody) {
    EXPECT_EQ(mistakesOf("Let f(x y) (x * y)\nSphere (f(2))\nSphere (f(1, 2, 3))\nSphere (f())\n"),
              "2:9 expr-E04 f(x, y) takes 2 arguments, found 1\n"
              "3:9 expr-E04 f(x, y) takes 2 arguments, found more\n"
              "4:9 expr-E04 f(x, y) takes 2 arguments, found 0");
    EXPECT_EQ(mistakesOf("Let f(x y) (x * y)\nLet g(x) (f(x, mat4(1)))\nSphere (1 + g(vec3(1)))\n"),
              "3:13 expr-E03 'g(vec3(1))': '*' does not combine vec3 and mat4 (line 1, column 13)");
    EXPECT_EQ(mistakesOf("Let f(x) (1 / x)\nLet g(x) (f(x - 1))\nSphere (2 + g(1 + 0 * time))\n"),
              "3:13 expr-E06 'g(1 + 0 * time)': '1 / x': division by zero (line 1, column 11)");
    EXPECT_EQ(mistakesOf("Let f(x) (x > 0 ? fill : line)\nState polygon (f(1))\nBox\n"),
              "2:16 expr-E02 'f(1)': unknown name 'fill'; a function has no words as its value (line 1, "
              "column 19)");
    EXPECT_EQ(mistakesOf("Let f(x) (x)\nSphere (f)\n"),
              "2:9 expr-E01 'f' is a function; its arguments follow in parentheses");
}

TEST(Functions, RefuseNamesThatHaveAMeaning) {
    EXPECT_EQ(mistakesOf("Let sin(x) (x)\nSphere (sin(2))\n"),
              "1:5 glib-E36 'sin' has a meaning of its own; choose another name");
    EXPECT_EQ(mistakesOf("Let f(x) (x)\nLet f(x y) (x)\nBox\n"),
              "2:5 glib-E36 'f' is declared on line 1 already, as a function");
    EXPECT_EQ(mistakesOf("Let f 3\nLet f(x) (x)\nBox\n"),
              "2:5 glib-E36 'f' is declared on line 1 already, as a variable");
    EXPECT_EQ(mistakesOf("Let f(x y x) (x)\nSphere (f(1))\n"),
              "1:11 glib-E18 Let: parameter 'x' given twice");
    EXPECT_EQ(mistakesOf("Let f(float x, float y) (x)\nSphere (f(1))\n"),
              "1:13 glib-E19 Let: expected the name of a parameter, found 'x'; a parameter has no type, "
              "since each call decides it");
    EXPECT_EQ(mistakesOf("Let f(2) (x)\nSphere (f(1))\n"),
              "1:7 glib-E19 Let: expected the name of a parameter, found '2'");
    EXPECT_EQ(mistakesOf("Let f (x) (2 * x)\nBox\n"),
              "1:11 glib-E18 Let: surplus argument '(2 * x)'; a function has no blank before its parameters: "
              "f(x)");
    EXPECT_EQ(mistakesOf("Let f(x) 3\nSphere (f(1))\n"),
              "1:10 glib-E19 Let: expected the value of the function 'f' in parentheses");
    EXPECT_EQ(mistakesOf("Group g\nLet f(x) (x)\nEndGroup\nDraw g\n"),
              "2:1 glib-E23 Let cannot stand inside Group (line 1); move it out");
}

TEST(Functions, ThatDoubleEachOtherEndWithAMessage) {
    std::string text = "Let f0(x) (x * 1.01)\n";
    for (int i = 1; i < 40; ++i)
        text += "Let f" + std::to_string(i) + "(x) (f" + std::to_string(i - 1) + "(x) + f" +
                std::to_string(i - 1) + "(x))\n";
    EXPECT_NE(mistakesOf(text + "Sphere (f39(1))\n").find("expr-E05"), std::string::npos);
    EXPECT_NE(mistakesOf(text + "Sphere (f39(time))\n").find("expr-E05"), std::string::npos);
}

}  // namespace
}  // namespace glibra::scene
