// Cameras and their warnings (language, 12.3).

#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat4x4.hpp>
#include <string>

#include "base/matrices.h"
#include "scene/view.h"
#include "support.h"

namespace glibra::scene {
namespace {

using tests::drawsOf;
using tests::idsOf;
using tests::placeOf;
using tests::run;
using tests::sceneAt;
using tests::scriptOf;
using tests::textsOf;
using tests::uniformValues;

const std::string kEye = "Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 50 .1 100\n";

TEST(Cameras, TheCameraEyeSeesTheWindow) {
    const Scene scene =
        run("Camera eye LookAt 0 0 5  0 0 0  0 1 0  Perspective 60 1 10\nTranslate 1 0 0\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics), "");
    const Draw draw = drawsOf(scene).at(0);
    EXPECT_EQ(placeOf(draw), glm::dvec3(1, 0, -5));
    EXPECT_EQ(std::get<Perspective>(*draw.projection).fieldOfView, 60);
    EXPECT_TRUE(scene.usesLookAt) << "the view policy leaves it alone";
}

TEST(Cameras, FieldsAgreeWithTheMatrices) {
    const Scene scene =
        run("WindowSize 200 100\nCamera sun LookAt 3 6 3  0 0 0  0 1 0  Perspective 70 1 20\n"
            "Vertex a.vert\nFragment a.frag\nProgram P uShadow (sun.shadow * model) uPlace (sun.position) "
            "uNear (sun.near) uAspect (sun.aspect)\nTranslate 1 2 3\nBox\n");
    EXPECT_EQ(textsOf(scene.diagnostics).find("-E"), std::string::npos) << textsOf(scene.diagnostics);
    const Draw draw = drawsOf(scene).at(0);
    const glm::dmat4 view = *base::viewingMatrix({3, 6, 3}, {0, 0, 0}, {0, 1, 0});
    const glm::dmat4 projection = base::perspectiveProjection(70, 2, 1, 20);
    const glm::dmat4 bias = base::translation({.5, .5, .5}) * base::scaling({.5, .5, .5});
    const glm::dmat4 expected = bias * (projection * view) * base::translation({1, 2, 3});
    const std::vector<double> got = uniformValues(scene, draw, "uShadow");
    ASSERT_EQ(got.size(), 16U);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_NEAR(got[i], expected[static_cast<int>(i / 4)][static_cast<int>(i % 4)], 1e-14) << i;
    const std::vector<double> place = uniformValues(scene, draw, "uPlace");
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(place[i], (std::array{3., 6., 3.}[i]), 1e-14);
    EXPECT_EQ(uniformValues(scene, draw, "uNear"), std::vector<double>{1});
    EXPECT_EQ(uniformValues(scene, draw, "uAspect"), std::vector<double>{2});
}

TEST(Cameras, AShiftMovesTheEyeInItsOwnAxes) {
    const Scene scene =
        run("Camera eye LookAt 5 0 0  0 0 0  0 1 0  Perspective 60 1 10\nCamera right Shift eye .5 0 0\n"
            "Vertex a.vert\nFragment a.frag\nProgram P uPlace (right.position)\nBox\n");
    const std::vector<double> place = uniformValues(scene, drawsOf(scene).at(0), "uPlace");
    // The eye looks along -x, so its right is -z.
    EXPECT_NEAR(place[0], 5, 1e-14);
    EXPECT_NEAR(place[2], -.5, 1e-14);
}

TEST(Cameras, AReflectedCameraSeesTheMirrorImage) {
    const Scene scene =
        run("Camera eye LookAt 1 3 6  0 0 0  0 1 0  Perspective 60 1 10\nCamera below Reflect eye 0 1 0 -1\n"
            "Vertex a.vert\nFragment a.frag\nProgram P uPlace (below.position)\nBox\n");
    const std::vector<double> place = uniformValues(scene, drawsOf(scene).at(0), "uPlace");
    EXPECT_NEAR(place[0], 1, 1e-13);
    EXPECT_NEAR(place[1], -1, 1e-13) << "mirrored about y = 1";
    EXPECT_NEAR(place[2], 6, 1e-13);
}

TEST(Cameras, AnObliqueNearPlaneClipsWhatIsBehindIt) {
    const glm::dmat4 projection = base::perspectiveProjection(60, 1.5, .1, 100);
    const glm::dvec4 plane(.3, .8, -.5, -2);
    const glm::dmat4 oblique = withNearPlane(projection, plane / glm::length(glm::dvec3(plane)));
    for (const glm::dvec3 point : {glm::dvec3(0, 4, -5), glm::dvec3(1, 1, -7), glm::dvec3(-2, 3, -9)}) {
        const glm::dvec4 clip = oblique * glm::dvec4(point, 1);
        const double side = glm::dot(plane, glm::dvec4(point, 1));
        EXPECT_EQ(clip.z >= -clip.w, side >= 0) << point.x;
        const glm::dvec4 plain = projection * glm::dvec4(point, 1);
        EXPECT_EQ(clip.x, plain.x);
        EXPECT_EQ(clip.w, plain.w);
    }
}

TEST(Cameras, FacesLookAlongTheAxesOfACubeMap) {
    const std::array<glm::dvec3, 6> directions{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (int face = 0; face < 6; ++face) {
        const glm::dmat4 view = faceView(face, {1, 2, 3});
        const glm::dvec4 seen =
            view * glm::dvec4(glm::dvec3(1, 2, 3) + directions[static_cast<std::size_t>(face)], 1);
        EXPECT_NEAR(seen.z, -1, 1e-15) << face;
        EXPECT_NEAR(seen.x, 0, 1e-15) << face;
    }
}

TEST(Cameras, MistakesAreReportedAtTheirPlace) {
    EXPECT_EQ(idsOf(run("Camera a LookAt 0 0 0 0 0 0 0 1 0 Perspective 60 1 10\nBox\n").diagnostics),
              "glib-E29");
    EXPECT_EQ(idsOf(run("Camera a LookAt 0 0 5 0 0 0 0 1 0 Perspective 200 1 10\nBox\n").diagnostics),
              "glib-E29");
    EXPECT_EQ(
        textsOf(run("Camera eye LookAt 0 0 5 0 0 0 0 1 0 Perspective 60 1 10\nCamera b Shift eys 1 0 0\n")
                    .diagnostics),
        "2:16 glib-E27 no camera 'eys' is declared before this line; did you mean 'eye'?");
}

TEST(Cameras, PrevIsTheCameraOneFrameBefore) {
    Interpretation script = scriptOf(
        "Fps 10\nCamera eye LookAt (time) 0 5  (time) 0 0  0 1 0  Perspective 60 1 10\n"
        "Vertex a.vert\nFragment a.frag\nProgram P uBefore (eye.prev.position) uNow (eye.position)\nBox\n");
    const Scene scene = sceneAt(script, 2);
    const Draw draw = drawsOf(scene).at(0);
    EXPECT_NEAR(uniformValues(scene, draw, "uNow").at(0), 2, 1e-14);
    EXPECT_NEAR(uniformValues(scene, draw, "uBefore").at(0), 1.9, 1e-14);
}

TEST(Cameras, PrevOfTheFirstPictureIsTheCameraItself) {
    Interpretation script = scriptOf(
        "Fps 10\nCamera eye LookAt (time) 0 5  (time) 0 0  0 1 0  Perspective 60 1 10\n"
        "Let before (eye.prev.position.x)\nLet ratio (1 / (1 + before))\n"
        "Vertex a.vert\nFragment a.frag\nProgram P uBefore (before) uRatio (ratio)\nBox\n");
    const auto before = [&](double time) {
        const Scene scene = sceneAt(script, time);
        std::string errors;
        for (const Diagnostic& each : scene.diagnostics)
            if (each.severity == Severity::error) errors += each.text;
        EXPECT_EQ(errors, "") << time;
        return uniformValues(scene, drawsOf(scene).at(0), "uBefore").at(0);
    };
    EXPECT_EQ(before(0), 0);
    EXPECT_NEAR(before(3), 2.9, 1e-14) << "whatever was drawn before";
    EXPECT_NEAR(before(1), .9, 1e-14);
    EXPECT_NEAR(before(.05), 0, 1e-14);
}

TEST(Cameras, PrevOfTheClassicViewHasAValue) {
    Interpretation script = scriptOf(
        "Fps 10\nLookAt (time) 0 5  0 0 0  0 1 0\nVertex a.vert\nFragment a.frag\n"
        "Program P uBefore (eye.prev.position)\nBox\n");
    const Scene scene = sceneAt(script, 2);
    EXPECT_EQ(tests::textsOf(scene.diagnostics).find("expr-E"), std::string::npos)
        << tests::textsOf(scene.diagnostics);
    EXPECT_NEAR(uniformValues(scene, drawsOf(scene).at(0), "uBefore").at(0), 1.9, 1e-12);
}

TEST(Cameras, AnEyeAfterEverythingThatIsDrawnIsReported) {
    const std::string late =
        "2:1 glib-W41 Camera 'eye' stands after everything that is drawn, so nothing is seen by it; move it "
        "up";
    EXPECT_EQ(textsOf(run("Sphere 1\n" + kEye).diagnostics), late);
    EXPECT_EQ(textsOf(run("Repeat 2\nSphere 1\nEndRepeat\n" + kEye).diagnostics).substr(4), late.substr(4));
    for (const char* before : {"", "Sphere 1\n"})
        for (const char* after :
             {"Sphere 1\n", "Pass window\nSphere 1\nEndPass\n",
              "Camera right Shift eye .1 0 0\nPass window from right\nSphere 1\nEndPass\n",
              "Let x (eye.position.x)\n", "Pass window from eye\nEndPass\n"})
            EXPECT_EQ(textsOf(run(before + kEye + after).diagnostics), "") << before << after;
}

}  // namespace
}  // namespace glibra::scene
