// The state machine: a draw uses the state that earlier statements set (language, 2.1, 3.1 and 3.2).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "glib/script.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawOf;
using tests::drawsOf;
using tests::idsOf;
using tests::run;
using tests::textsOf;

/// M * (x, y, z, 1), component by component.
glm::dvec3 moved(const glm::dmat4& m, const glm::dvec3& p) {
    glm::dvec3 result;
    for (int row = 0; row < 3; ++row)
        result[row] = m[0][row] * p.x + m[1][row] * p.y + m[2][row] * p.z + m[3][row];
    return result;
}

void expectAt(const glm::dvec3& a, const glm::dvec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-14) << "component " << i;
}

TEST(State, InitialValuesAreThoseOfTheLanguage) {
    const Scene scene = run("Sphere\n");
    const Draw draw = drawsOf(scene).at(0);
    EXPECT_EQ(draw.modelView, glm::dmat4(1.0));
    const auto& view = std::get<Perspective>(*draw.projection);
    EXPECT_EQ(view.fieldOfView, 50);
    EXPECT_EQ(view.near, .1);
    EXPECT_EQ(view.far, 1000);
    EXPECT_EQ(draw.color, glm::dvec4(1.0));
    EXPECT_FALSE(draw.program);
    EXPECT_EQ(draw.patchVertices, 3);
    EXPECT_EQ(draw.raster->lineWidth, 1);
    EXPECT_EQ(draw.raster->pointSize, 1);
    EXPECT_FALSE(draw.raster->pointSizeFromShader);
    EXPECT_FALSE(draw.flatColors);
    EXPECT_FALSE(draw.sampling.clamp);
    EXPECT_EQ(draw.timerPeriod, 10);
    EXPECT_EQ(scene.width, 600);
    EXPECT_EQ(scene.height, 600);
    EXPECT_EQ(scene.frame.passes.at(0).clearColors.at(0), glm::dvec4(18 / 255., 27 / 255., 33 / 255., 1));
    EXPECT_FALSE(scene.usesLookAt);
    EXPECT_TRUE(scene.diagnostics.empty());
}

TEST(FullScreen, IsNotPlacedByTheView) {
    const Draw draw = drawsOf(run("Perspective 40\nLookAt 1 2 3 0 0 0 0 1 0\nScale 2\nFullScreen\n")).at(0);
    EXPECT_TRUE(std::holds_alternative<ClipSpace>(*draw.projection));
    EXPECT_EQ(draw.modelView, glm::dmat4(1.0));
    EXPECT_TRUE(draw.raster == drawOf("Sphere\n").raster);
}

TEST(SkyBox, KeepsRotationsAndScalesOnly) {
    const Draw draw = drawOf(
        "LookAt 1 2 3 1 2 0 0 1 0\nTranslate 5 6 7\nRotate 90 0 1 0\nScale 2\nTranslate 1 0 0\nSkyBox\n");
    EXPECT_TRUE(draw.isSky);
    expectAt(moved(draw.modelView, {0, 0, 0}), {0, 0, 0});
    expectAt(moved(draw.modelView, {1, 0, 0}), {0, 0, -2});
    EXPECT_TRUE(draw.raster->depthClamp);
    EXPECT_EQ(draw.raster->depthNear, 1);
    EXPECT_EQ(draw.raster->depthFar, 1);
    const Draw next = drawsOf(run("SkyBox\nTranslate 1 0 0\nBox\n")).at(1);
    EXPECT_FALSE(next.isSky);
    EXPECT_FALSE(next.raster->depthClamp);
    expectAt(moved(next.modelView, {0, 0, 0}), {1, 0, 0});
}

TEST(DrawIds, AreDifferentWithinAScene) {
    const std::string text =
        "Sphere\n\nBox\nglBegin lines\nglVertex 0 0 0\nglVertex 1 0 0\nglEnd\nSphere\nTeapot\n";
    std::set<DrawId> ids;
    for (const Draw& draw : drawsOf(run(text))) {
        EXPECT_EQ(draw.id.line, draw.place.line);
        EXPECT_EQ(draw.id.file, 0);
        EXPECT_EQ(draw.id.counter, 0) << "one draw per line";
        EXPECT_TRUE(ids.insert(draw.id).second);
    }
    EXPECT_EQ(ids.size(), 5U);
}

TEST(State, LaterStatementsNeverChangeEarlierDraws) {
    const auto draws =
        drawsOf(run("Color 1 0 0\nSphere\nColor 0 1 0\nTranslate 1 0 0\nOrtho\nFlat\nClamp\nTimer 3\n"
                    "LineWidth 4\nPointSize 5\nPointSizeMode\nNumPatchVertices 16\nSphere\n"));
    ASSERT_EQ(draws.size(), 2U);
    EXPECT_EQ(draws[0].color, glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(draws[0].modelView, glm::dmat4(1.0));
    EXPECT_TRUE(std::holds_alternative<Perspective>(*draws[0].projection));
    EXPECT_EQ(draws[1].color, glm::dvec4(0, 1, 0, 1));
    expectAt(moved(draws[1].modelView, {0, 0, 0}), {1, 0, 0});
    EXPECT_TRUE(std::holds_alternative<Orthographic>(*draws[1].projection));
    EXPECT_TRUE(draws[1].flatColors);
    EXPECT_TRUE(draws[1].sampling.clamp);
    EXPECT_EQ(draws[1].timerPeriod, 3);
    EXPECT_EQ(draws[1].raster->lineWidth, 4);
    EXPECT_EQ(draws[1].raster->pointSize, 5);
    EXPECT_TRUE(draws[1].raster->pointSizeFromShader);
    EXPECT_EQ(draws[1].patchVertices, 16);
    EXPECT_EQ(draws[0].shape, draws[1].shape);
}

TEST(State, SwitchesCanBeTurnedBack) {
    const Draw draw = drawOf("Flat\nSmooth\nClamp\nClamp off\nPointSizeMode 1\nPointSizeMode 0\nSphere\n");
    EXPECT_FALSE(draw.flatColors);
    EXPECT_FALSE(draw.sampling.clamp);
    EXPECT_FALSE(draw.raster->pointSizeFromShader);
}

TEST(State, TransformsAreMultipliedFromTheRight) {
    const Draw draw = drawOf("Translate 1 2 3\nRotate 90 0 0 1\nScale 2\nSphere\n");
    // The point is scaled, then turned from x to y, then translated.
    expectAt(moved(draw.modelView, {1, 0, 0}), {1, 4, 3});
    expectAt(moved(draw.modelView, {0, 1, 0}), {-1, 2, 3});
    expectAt(moved(draw.modelView, {0, 0, 1}), {1, 2, 5});
}

TEST(State, RotationIsRightHandedAboutAnyAxis) {
    const Draw draw = drawOf("Rotate 120 1 1 1\nSphere\n");
    expectAt(moved(draw.modelView, {1, 0, 0}), {0, 1, 0});
    expectAt(moved(draw.modelView, {0, 1, 0}), {0, 0, 1});
}

TEST(State, RotationAboutTheZeroVectorDoesNothing) {
    EXPECT_EQ(drawOf("Rotate 30 0 0 0\nSphere\n").modelView, glm::dmat4(1.0));
}

TEST(State, OneFactorScalesAllAxesAndTwoLeaveZAlone) {
    expectAt(moved(drawOf("Scale 3\nSphere\n").modelView, {1, 1, 1}), {3, 3, 3});
    expectAt(moved(drawOf("Scale 3 4\nSphere\n").modelView, {1, 1, 1}), {3, 4, 1});
    expectAt(moved(drawOf("Scale 3 4 5\nSphere\n").modelView, {1, 1, 1}), {3, 4, 5});
}

TEST(State, PushAndPopBracketTheMatrixOnly) {
    const auto draws =
        drawsOf(run("PushMatrix\nTranslate 1 0 0\nColor 1 0 0\nSphere\nTransformEnd\nSphere\n"));
    expectAt(moved(draws.at(0).modelView, {}), {1, 0, 0});
    EXPECT_EQ(draws.at(1).modelView, glm::dmat4(1.0));
    EXPECT_EQ(draws.at(1).color, glm::dvec4(1, 0, 0, 1));
}

TEST(State, LookAtReplacesTheTopMatrixOnly) {
    const auto draws =
        drawsOf(run("Translate 9 9 9\nPushMatrix\nLookAt 0 0 5 0 0 0 0 1 0\nSphere\nPopMatrix\nSphere\n"));
    expectAt(moved(draws.at(0).modelView, {1, 2, 3}), {1, 2, -2});
    expectAt(moved(draws.at(1).modelView, {}), {9, 9, 9});
}

TEST(State, LookAtPutsTheCentreAheadAndUpUp) {
    const Scene scene = run("LookAt 3 4 5  3 4 -5  1 0 0\nSphere\n");
    const Draw draw = drawsOf(scene).at(0);
    expectAt(moved(draw.modelView, {3, 4, 5}), {0, 0, 0});
    expectAt(moved(draw.modelView, {3, 4, -5}), {0, 0, -10});
    expectAt(moved(draw.modelView, {4, 4, 5}), {0, 1, 0});
    expectAt(moved(draw.modelView, {3, 5, 5}), {-1, 0, 0});
    EXPECT_TRUE(scene.usesLookAt);
    EXPECT_EQ(scene.view, draw.modelView);
}

TEST(State, LookAtFromTheCentreItselfIsAnError) {
    const Scene scene = run("LookAt 1 2 3 1 2 3 0 1 0\nSphere\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "1:1 glib-E13 LookAt: eye and centre are the same point");
    EXPECT_FALSE(scene.usesLookAt);
}

TEST(State, LookAtWithParallelUpUsesTheFirstAxisThatIsNotParallel) {
    const Scene down = run("LookAt 0 5 0 0 0 0 0 1 0\nSphere\n");
    EXPECT_EQ(textsOf(down.diagnostics),
              "1:1 glib-W30 LookAt: up is parallel to the view direction; +z is used instead");
    expectAt(moved(drawsOf(down).at(0).modelView, {0, 0, 1}), {0, 1, -5});
    const Scene ahead = run("LookAt 0 0 5 0 0 0 0 0 -2\nSphere\n");
    EXPECT_EQ(textsOf(ahead.diagnostics),
              "1:1 glib-W30 LookAt: up is parallel to the view direction; +y is used instead");
    EXPECT_EQ(idsOf(run("LookAt 0 0 5 0 0 0 0 0 0\nSphere\n").diagnostics), "glib-W30");
}

TEST(State, PopWithoutPushIsAnErrorAndChangesNothing) {
    const Scene scene = run("Translate 1 0 0\nPopMatrix\nSphere\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "2:1 glib-E06 PopMatrix without PushMatrix");
    expectAt(moved(drawsOf(scene).at(0).modelView, {}), {1, 0, 0});
}

TEST(State, PushesThatAreNeverPoppedAreCounted) {
    EXPECT_EQ(textsOf(run("PushMatrix\nPushMatrix\nPopMatrix\nSphere\n").diagnostics),
              "1:1 glib-W31 1 PushMatrix without PopMatrix at the end of the file");
    EXPECT_EQ(textsOf(run("PushMatrix\nPushMatrix\nSphere\n").diagnostics),
              "2:1 glib-W31 2 PushMatrix without PopMatrix at the end of the file");
}

TEST(State, TheStackHolds256Matrices) {
    std::string text;
    for (int i = 0; i < 256; ++i) text += "PushMatrix\n";
    for (int i = 0; i < 256; ++i) text += "PopMatrix\n";
    EXPECT_EQ(idsOf(run(text).diagnostics), "");
    std::string more;
    for (int i = 0; i < 257; ++i) more += "PushMatrix\n";
    EXPECT_EQ(textsOf(run(more).diagnostics),
              "256:1 glib-W31 256 PushMatrix without PopMatrix at the end of the file\n"
              "257:1 glib-E15 PushMatrix: the limit is 256 matrices");
}

TEST(State, MessagesAreCappedAsThoseOfTheParserAre) {
    std::string text = "Verbose\n";
    for (int i = 0; i < 5'000; ++i) text += "PushMatrix\n";
    const Diagnostics found = run(text).diagnostics;
    std::size_t errors = 0, notes = 0;
    for (const Diagnostic& each : found) {
        errors += each.severity == Severity::error ? 1U : 0U;
        notes += each.id == "glib-N02" ? 1U : 0U;
    }
    EXPECT_EQ(errors, 100U);
    EXPECT_EQ(notes, 5'001U) << "what the scene asks for, a note per command, is not cut";
    // 4744 are too deep, and one message says that all are open at the end.
    EXPECT_EQ(found.back().text, "4645 more messages not shown, 4644 errors of them") << found.back().text;
}

TEST(State, AnErrorIsNotCutBehindWarnings) {
    std::string text;
    for (int i = 0; i < 120; ++i) text += "WindowSize " + std::to_string(300 + i) + " 300\n";
    text += "Verbose\nPopMatrix\n";
    const Diagnostics found = run(text).diagnostics;
    EXPECT_TRUE(hasError(found));
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [](const Diagnostic& each) { return each.id == "glib-N02"; }));
}

TEST(State, MatricesThatLeaveTheRangeOfFloatsAreRefused) {
    const Scene scene = run("Scale 1e30\nScale 1e30\nSphere\n");
    EXPECT_EQ(idsOf(scene.diagnostics), "glib-E31");
    expectAt(moved(drawsOf(scene).at(0).modelView, {1e-30, 0, 0}), {1, 0, 0});
}

TEST(State, OneNumberIsGreyAndAlphaIsOptional) {
    EXPECT_EQ(drawOf("Color .25\nSphere\n").color, glm::dvec4(.25, .25, .25, 1));
    EXPECT_EQ(drawOf("Color .25 .5\nSphere\n").color, glm::dvec4(.25, .5, 0, 1));
    EXPECT_EQ(drawOf("Color .25 .5 .75 .125\nSphere\n").color, glm::dvec4(.25, .5, .75, .125));
}

TEST(State, OrthoTakesSixNumbersAsGiven) {
    const Draw draw = drawOf("Ortho -1 2 -3 4 5 6\nSphere\n");
    const auto& box = std::get<Orthographic>(*draw.projection);
    EXPECT_EQ(box.left, -1);
    EXPECT_EQ(box.right, 2);
    EXPECT_EQ(box.bottom, -3);
    EXPECT_EQ(box.top, 4);
    EXPECT_EQ(box.near, 5);
    EXPECT_EQ(box.far, 6);
}

TEST(State, TheLastWindowSizeWins) {
    const Scene scene = run("WindowSize 600 600\nSphere\nWindowSize 800 700\n");
    EXPECT_EQ(scene.width, 800);
    EXPECT_EQ(scene.height, 700);
    EXPECT_EQ(textsOf(scene.diagnostics), "3:1 glib-W34 WindowSize is given twice; 800 700 replaces 600 600");
    EXPECT_EQ(idsOf(run("WindowSize 600 600\nWindowSize 600 600\n").diagnostics), "");
}

TEST(State, MessagesAreNotes) {
    const Scene scene = run("MessageBox Move the scene back\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "1:1 glib-N01 MessageBox: Move the scene back");
    EXPECT_EQ(scene.diagnostics.at(0).severity, Severity::note);
}

TEST(State, TextsOfMessagesAreListedAsWritten) {
    EXPECT_EQ(run("MessageBox MessageBox: one\nSphere\nMessageBox two\n").messages,
              (std::vector<std::string>{"MessageBox: one", "two"}));
    EXPECT_TRUE(run("Sphere\n").messages.empty());
}

TEST(State, EveryStatementThatLacksItsFileIsListed) {
    const auto missingOf = [](const std::string& statement) {
        std::string all;
        const glib::Script script = glib::parse("Sphere\n" + statement + "\n", "scene.glib");
        for (const MissingFile& each : interpret(script).missingFiles)
            all += fmt::format("{}:{} {} {}", each.place.line, each.place.column, each.word,
                               each.isModel ? "model" : "texture");
        return all;
    };
    for (const char* model : {"Obj", "WireObj", "ObjAdj", "ObjPatch", "Shp"}) {
        EXPECT_EQ(missingOf(model), fmt::format("2:1 {} model", model));
        EXPECT_EQ(missingOf(fmt::format("{} cow.obj", model)), "");
    }
    for (const char* texture : {"Texture1D", "Texture2D", "Texture3D", "Texture"}) {
        EXPECT_EQ(missingOf(fmt::format("{} 0", texture)), fmt::format("2:1 {} texture", texture));
        EXPECT_EQ(missingOf(fmt::format("{} 0 a.png", texture)), "");
    }
}

TEST(State, VerboseReportsEveryOperationOfTheWholeFile) {
    const Scene scene = run("Translate 1 0 -2.5\nSphere 1 60 60\nProgram Dots uA 1\nSphere\nVerbose\n");
    EXPECT_TRUE(scene.verbose);
    EXPECT_EQ(textsOf(scene.diagnostics),
              "1:1 glib-N02 Translate 1 0 -2.5\n"
              "2:1 glib-N02 Sphere: 3719 vertices, 7080 triangles, built-in program\n"
              "3:1 glib-N02 Program 'Dots'\n"
              "4:1 glib-N02 Sphere: 3719 vertices, 7080 triangles, program 'Dots'\n"
              "5:1 glib-N02 Verbose");
}

TEST(State, TheSameScriptGivesTheSameSceneTwice) {
    const glib::Script script =
        glib::parse("Color 1 0 0\nTranslate 1 2 3\nSphere\nTeapot\nSphere\n", "a.glib");
    const Scene first = interpret(script);
    const Scene second = interpret(script);
    ASSERT_EQ(drawsOf(first).size(), drawsOf(second).size());
    for (std::size_t i = 0; i < drawsOf(first).size(); ++i) {
        EXPECT_EQ(drawsOf(first)[i].shape, drawsOf(second)[i].shape);
        EXPECT_EQ(drawsOf(first)[i].modelView, drawsOf(second)[i].modelView);
    }
}

TEST(State, DiagnosticsNameTheSceneFile) {
    const Scene scene = run("PopMatrix\n", "some/folder/a.glib");
    EXPECT_EQ(scene.diagnostics.at(0).place.file, "some/folder/a.glib");
    EXPECT_EQ(scene.path, "some/folder/a.glib");
}

}  // namespace
}  // namespace glibra::scene
