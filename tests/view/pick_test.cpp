#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

int lineAt(Session& session, int x, int y) {
    session.pickAt(x, y);
    return session.look().picked() ? session.look().picked()->draw.line : 0;
}

TEST(Picking, FindsTheNearestObjectWhateverTheOrder) {
    const SceneFolder folder(
        "WindowSize 40 20\nOrtho -2 2 -1 1\nColor 1 0 0\nQuadXY .5 1\nColor 0 1 0\nQuadXY 0 1\nTranslate 1 0 "
        "0\n"
        "Color 0 0 1\nQuadXY .2 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(lineAt(session, 15, 10), 4);
    EXPECT_EQ(lineAt(session, 35, 10), 9);
    EXPECT_EQ(lineAt(session, 25, 10), 4);
    EXPECT_EQ(lineAt(session, 2, 10), 0);
    EXPECT_FALSE(session.look().picked());
    EXPECT_EQ(lineAt(session, -5, 10), 0);
}

TEST(Picking, SeesWhatShadersDiscardAndMove) {
    const SceneFolder folder(
        "WindowSize 40 20\nOrtho -2 2 -1 1\nColor 1 0 0\nQuadXY 0 .2\nVertex a.vert\nFragment "
        "a.frag\nProgram P\n"
        "QuadXY .5 1\n",
        {{"a.vert",
          "#version 330\nout vec4 vST;\nvoid main() { vST = aTexCoord0; gl_Position = "
          "uModelViewProjectionMatrix * "
          "(aVertex + vec4(1., 0., 0., 0.)); }\n"},
         {"a.frag",
          "#version 330\nin vec4 vST; out vec4 c;\nvoid main() { if (vST.t > .5) discard; c = vec4(1.); "
          "}\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(lineAt(session, 30, 15), 8) << "moved to the right";
    EXPECT_EQ(lineAt(session, 30, 5), 0) << "discarded";
    EXPECT_EQ(lineAt(session, 19, 9), 4);
    EXPECT_EQ(lineAt(session, 21, 9), 4) << "through the hole";
    EXPECT_EQ(lineAt(session, 12, 15), 0) << "moved away";
}

TEST(Picking, LeavesThePictureAsItWas) {
    const SceneFolder folder("WindowSize 40 20\nOrtho -2 2 -1 1\nColor 1 0 0 .5\nQuadXY 0 1\nQuadXY .1 .5\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> before = pixelsOf(session);
    EXPECT_EQ(lineAt(session, 20, 10), 5);
    EXPECT_EQ(pixelsOf(session), before);
}

TEST(Picking, GivesThePointUnderTheMouse) {
    const SceneFolder folder(
        "WindowSize 40 40\nPerspective 60\nLookAt 0 0 4 0 0 0 0 1 0\nTranslate 0 0 1\nColor 1 0 0\nQuadXY 0 "
        "1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.pickAt(20, 20);
    ASSERT_TRUE(session.look().picked());
    EXPECT_NEAR(session.look().picked()->eye.z, -3, 1e-3);
    EXPECT_NEAR(session.look().picked()->point.z, 0, 1e-3);
    const double pixel = 2 * 3 * std::tan(30 * 3.14159265 / 180) / 40;
    EXPECT_NEAR(session.look().picked()->point.x, pixel / 2, 1e-3);
}

TEST(Picking, GivesThePointInReversedDepth) {
    const SceneFolder folder(
        "WindowSize 40 40\nCamera eye LookAt 0 0 0  0 0 -1  0 1 0  Perspective 60 .01 1e6\nPass window "
        "reversed\nTranslate 0 0 -90000\nQuadXY 0 20000\nEndPass\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.pickAt(20, 20);
    ASSERT_TRUE(session.look().picked());
    EXPECT_NEAR(session.look().picked()->eye.z, -90000, 1);
    EXPECT_NEAR(session.look().picked()->point.z, 0, 1);
    session.pickAt(1, 1);
    EXPECT_FALSE(session.look().picked());
}

TEST(Picking, TheObjectTransformMovesThePickedOneOnly) {
    const SceneFolder folder(
        "WindowSize 40 20\nOrtho -2 2 -1 1\nColor 1 0 0\nQuadXY 0 .5\nTranslate 1 0 0\nColor 0 1 0\nQuadXY 0 "
        ".3\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.look().drag(view::TransformMode::object, {view::Gesture::pan, {-10, 0}, {40, 20}});
    EXPECT_TRUE(session.look().view() == ViewState{}) << "nothing is picked";
    EXPECT_EQ(lineAt(session, 20, 10), 4);
    session.look().drag(view::TransformMode::object, {view::Gesture::pan, {-10, 0}, {40, 20}});
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 10, 10), (std::array<int, 3>{255, 0, 0}));
    EXPECT_EQ(pixelOf(session, 20, 10), (std::array<int, 3>{18, 27, 33}));
    EXPECT_EQ(pixelOf(session, 30, 10), (std::array<int, 3>{0, 255, 0}));
}

TEST(Picking, KnowsTheMiddleAndTheSizeOfTheObject) {
    const SceneFolder folder("WindowSize 40 40\nOrtho -2 2 -2 2\nTranslate .5 0 0\nBox 1 2 .5\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.pickAt(27, 25);
    ASSERT_TRUE(session.look().picked());
    EXPECT_EQ(session.look().picked()->centre, glm::dvec3(0));
    EXPECT_EQ(session.look().picked()->half, glm::dvec3(.5, 1, .25));
    EXPECT_NE(session.look().picked()->point, glm::dvec3(0));
}

TEST(Picking, TakesThePointWhereAProgramMovesTheVertices) {
    const SceneFolder folder(
        "WindowSize 40 40\nOrtho -2 2 -2 2\nVertex a.vert\nFragment a.frag\nProgram P\nBox 1\n",
        {{"a.vert",
          "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * (aVertex * "
          "vec4(2., 2., 2., 1.)); }\n"},
         {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.pickAt(25, 25);
    ASSERT_TRUE(session.look().picked());
    EXPECT_EQ(session.look().picked()->centre, session.look().picked()->point);
    EXPECT_EQ(session.look().picked()->half, glm::dvec3(0));
}

}  // namespace
}  // namespace glibra::test
