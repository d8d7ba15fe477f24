// Which names a statement sees, and what they mean there (language, 12.2). tests/fuzz/scopes.cpp compares
// generated programs with a reference interpreter.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "glib/script.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::TemporaryFolder;
using tests::textsOf;

/// The first number of each shape that is drawn: `QuadXY (k) 1` shows k.
std::vector<double> shownBy(const Scene& scene) {
    std::vector<double> shown;
    for (const Draw& each : drawsOf(scene)) shown.push_back(scene.shapes[each.shape].numbers.at(0));
    return shown;
}

/// The same of a text, which must have no messages.
std::vector<double> shownBy(std::string_view text) {
    const Scene scene = run(text);
    EXPECT_EQ(textsOf(scene.diagnostics), "") << text;
    return shownBy(scene);
}

using Numbers = std::vector<double>;

TEST(Scopes, EachPassChoosesItsCameraOfAnArray) {
    const Scene scene =
        run("Camera at[3] LookAt (i) 0 5  (i) 0 0  0 1 0  Ortho -1 1 -1 1 1 10\n"
            "Camera up[2] LookAt 0 (i) 5  0 (i) 0  0 1 0  Ortho -1 1 -1 1 1 10\n"
            "Repeat 2 as k\nPass window from at[k]\nEndPass\nEndRepeat\n"
            "Repeat 2 as k\nPass window from at[2 - k] keep\nEndPass\nPass window from up[k] keep\nEndPass\n"
            "EndRepeat\n"
            "Group g k 0\nPass window from at[k] keep\nEndPass\nEndGroup\nDraw g k 2\nDraw g\n"
            "Repeat [at up] as c\nPass window from c[1] keep\nEndPass\nEndRepeat\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    std::string cameras;
    for (const Pass& each : scene.frame.passes) cameras += each.camera + " ";
    EXPECT_EQ(cameras, "at[0] at[1] at[2] up[0] at[1] up[1] at[2] at[0] at[1] up[1] ");
}

TEST(Scopes, LetInAGroupIsReadWhoeverDrawsTheGroup) {
    const std::string group =
        "Group row\nRepeat 2 as step\nLet place (10*step)\nQuadXY (place) 1\nEndRepeat\nEndGroup\n";
    EXPECT_EQ(shownBy(group + "Draw row\n"), (Numbers{0, 10}));
    EXPECT_EQ(shownBy(group + "Repeat 1 as place\nDraw row\nEndRepeat\n"), (Numbers{0, 10}));
    EXPECT_EQ(shownBy(group + "Repeat 1 as place\nDraw row\nEndRepeat\nDraw row\n"), (Numbers{0, 10, 0, 10}));
    EXPECT_EQ(shownBy(group + "Repeat [7 8] as place\nDraw row\nEndRepeat\n"), (Numbers{0, 10, 0, 10}));
    EXPECT_EQ(shownBy(group + "Repeat [up down] as place\nDraw row\nEndRepeat\n"), (Numbers{0, 10, 0, 10}));
    EXPECT_EQ(shownBy(group + "Group outer place 4\nDraw row\nQuadXY (place) 1\nEndGroup\nDraw outer\n"),
              (Numbers{0, 10, 4}));
    EXPECT_EQ(shownBy("Group row\nLet place[2] (5 + i)\nQuadXY (place[1]) 1\nEndGroup\n"
                      "Repeat 1 as place\nDraw row\nEndRepeat\n"),
              (Numbers{6}));
}

TEST(Scopes, AVariableOfTheSceneIsNotHiddenByTheCaller) {
    EXPECT_EQ(shownBy("Let k (5)\nGroup g\nQuadXY (k) 1\nEndGroup\n"
                      "Repeat 2 as k\nDraw g\nQuadXY (k) 1\nEndRepeat\nDraw g\n"),
              (Numbers{5, 0, 5, 1, 5}));
    // The scene has a variable of this name, even if its Let has not run.
    const Scene scene = run("Group g\nQuadXY (k) 1\nEndGroup\nRepeat 1 as k\nDraw g\nEndRepeat\nLet k (5)\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "expr-E02") << textsOf(scene.diagnostics);
}

TEST(Scopes, ANameThatOnlyTheCallerHasIsTheCallers) {
    EXPECT_EQ(shownBy("Group g\nQuadXY (k) 1\nEndGroup\n"
                      "Repeat 2 as k\nDraw g\nEndRepeat\nRepeat [7 8] as k\nDraw g\nEndRepeat\n"
                      "Group h k 3\nDraw g\nEndGroup\nDraw h\n"),
              (Numbers{0, 1, 7, 8, 3}));
    EXPECT_EQ(shownBy("Repeat 2 as k\nGroup g\nQuadXY (k) 1\nEndGroup\nGroup h k 9\nDraw g\nEndGroup\n"
                      "Draw h\nEndRepeat\n"),
              (Numbers{0, 1}))
        << "a group sees the block that it stands in";
}

TEST(Scopes, LetOverACounterIsReadToTheEndOfItsScope) {
    const Scene scene =
        run("Repeat 2 as k\nLet k (10*k + 5)\nQuadXY (k) 1\nGroup\nQuadXY (k) 1\nEndGroup\nEndRepeat\nQuadXY "
            "(k) 1\n"
            "Group g size 2\nLet size (size*2)\nQuadXY (size) 1\nEndGroup\nDraw g\nDraw g size 5\n");
    EXPECT_EQ(shownBy(scene), (Numbers{5, 5, 15, 15, 15, 4, 10}));
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-W40 glib-W40");
    EXPECT_EQ(scene.diagnostics.front().place.line, 2);
}

TEST(Scopes, ParametersHaveAnotherTypeAtEachDraw) {
    EXPECT_EQ(shownBy("Group g p 0\nQuadXY (float(p)) 1\nEndGroup\n"
                      "Draw g p (vec3(1, 2, 3))\nDraw g p 4\nDraw g\nDraw g p (vec2(5, 6))\nDraw g p 7\n"),
              (Numbers{1, 4, 0, 5, 7}));
    EXPECT_EQ(
        shownBy("Texture2D flat 8 4 rgba8 mipmap\nTexture3D deep 8 4 2 rgba8\nBuffer data float 3\n"
                "Group size t flat\nQuadXY (float(t.size * t.size)) 1\nEndGroup\n"
                "Group count t data\nQuadXY (t.count) 1\nEndGroup\n"
                "Draw size\nDraw size t deep\nDraw size t flat.level(1)\nDraw size t flat\nDraw count\n"),
        (Numbers{64, 64, 16, 64, 3}));
    const Scene scene = run("Group g p 0\nLet list[2] (p)\nEndGroup\nDraw g\nDraw g p (vec2(1, 2))\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E36") << textsOf(scene.diagnostics);
}

TEST(Scopes, FieldsBelongToTheNameThatIsSeen) {
    const Scene scene = run(
        "Texture2D t 8 4 rgba8\nGroup g t 5\nQuadXY (t) 1\nQuadXY (float(t.size)) 1\nEndGroup\nDraw g t 6\n");
    EXPECT_NE(idsOf(scene.diagnostics), "") << "a number has no size";
}

TEST(Scopes, ObjectsOfTheCallerAreNotThoseOfTheGroup) {
    const Scene scene =
        run("Texture2D one 8 8 rgba8\nTexture2D two 8 8 rgba8\nTexture2D three 8 8 rgba8\n"
            "Group inner\nPass one\nEndPass\nEndGroup\n"
            "Group outer one three\nDraw inner\nPass one\nEndPass\nEndGroup\n"
            "Draw outer one two\nDraw outer\nDraw inner\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    std::string targets;
    for (const Pass& each : scene.frame.passes)
        if (!each.targets.empty()) targets += scene.textures[each.targets.at(0)].name + " ";
    EXPECT_EQ(targets, "one two one three one ");
}

TEST(Scopes, SetReadsTheNamesWhereItStands) {
    const Scene scene =
        run("Group g k 5\nQuadXY 0 1\nEndGroup\n"
            "Repeat 2 as k\nSet uK (k)\nDraw g\nRepeat 1 as k\nQuadXY 0 1\nEndRepeat\nEndRepeat\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    Numbers values;
    for (const Draw& each : drawsOf(scene))
        values.push_back(scene.uniformSets[each.uniforms].values.at(0).values.at(0));
    EXPECT_EQ(values, (Numbers{0, 0, 1, 1}));
}

TEST(Scopes, ValuesOfIncludeAreThoseOfTheFile) {
    const TemporaryFolder folder;
    folder.write(
        "part.glib",
        "Let size (1)\nGroup own\nLet size (size)\nQuadXY (size) 1\nEndGroup\nDraw own\nDraw other\n");
    const auto path = folder.write("scene.glib");
    const Scene scene =
        run("Group other\nLet size (2)\nQuadXY (size) 1\nEndGroup\nInclude part.glib size 7\nDraw own\nDraw "
            "other\n",
            path);
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    EXPECT_EQ(shownBy(scene), (Numbers{7, 2, 7, 2}));
}

TEST(Scopes, AFrameIsTheSameWhateverRanBefore) {
    const char* const text =
        "When (time < 1)\nLet v (3)\nElse\nLet v (vec2(4, 5))\nEndWhen\nLet a[1 + int(time)] (i)\n"
        "Group g\nQuadXY (float(v) + a[int(time)]) 1\nEndGroup\nRepeat 1 as v\nDraw g\nEndRepeat\n";
    const auto at = [&](Interpretation& script, double time) {
        const Scene scene = script.at({.time = time});
        EXPECT_EQ(textsOf(scene.diagnostics), "") << time;
        return shownBy(scene);
    };
    Interpretation script(glib::parse(text, "scene.glib"), {});
    for (const double time : {0., 2., 0., 1., 2., 1.}) {
        Interpretation alone(glib::parse(text, "scene.glib"), {});
        EXPECT_EQ(at(script, time), at(alone, time)) << time;
    }
}

TEST(Scopes, EmptyRoundsCount) {
    const std::string nested =
        "Repeat 1000000\nRepeat 1000000\nRepeat 1000000\nEndRepeat\nEndRepeat\nEndRepeat\n";
    const Scene scene = run(nested + "QuadXY 0 1\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "3:1 glib-E15 the frame has more than 1,000,000 rounds of Repeat");
    EXPECT_EQ(idsOf(run("Repeat 1000000\nEndRepeat\n").diagnostics), "");
    EXPECT_EQ(idsOf(run("Repeat 1000\nLet list[65536] (i)\nEndRepeat\n").diagnostics), "glib-E15");
    EXPECT_EQ(
        idsOf(run("Repeat 100000\nCamera c[256] LookAt (i) 0 5 0 0 0 0 1 0 Ortho -1 1 -1 1 1 10\nEndRepeat\n")
                  .diagnostics),
        "glib-E15");
}

TEST(Scopes, ChecksThatDoNotRunAreNamedWithTheReason) {
    const Scene scene = run(
        "Group g\nExpect primitives 1\nEndGroup\nRepeat 0\nExpect primitives 2\nEndRepeat\n"
        "When (1 > 2)\nRepeat 2\nExpect primitives 3 at 2\nEndRepeat\nElse\nExpect primitives 4\nEndWhen\n"
        "Repeat 2 as k\nWhen (k == 0)\nExpect primitives 5\nEndWhen\nEndRepeat\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    std::string idle;
    for (const IdleCheck& each : scene.idleChecks)
        idle += std::to_string(each.place.line) + (each.mayRun ? " may run: " : ": ") + each.why +
                (each.seconds ? " at 2\n" : "\n");
    EXPECT_EQ(idle,
              "2: group 'g' is not drawn\n5: the Repeat on line 4 has no round\n"
              "9 may run: the condition of the When on line 7 is false at 2\n");
    EXPECT_EQ(scene.checks.size(), 2U);
}

}  // namespace
}  // namespace glibra::scene
