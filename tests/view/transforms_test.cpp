// The transforms and projections of a view in the picture.

#include <glm/gtc/type_ptr.hpp>

#include "render/draw/view_matrices.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

/// A shader that shows a matrix: red, green and blue are its elements [3][0], [3][1] and [3][2].
std::map<std::string, std::string> matrixFiles(const std::string& name) {
    return {{"a.vert", "#version 330\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n"},
            {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(" + name + "[3].xyz, 1.); }\n"}};
}

Color shownMatrix(const std::string& name, const ViewState& view,
                  const std::string& projection = "Ortho -1 1 -1 1") {
    const SceneFolder folder(
        "WindowSize 16 16\n" + projection + "\nVertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
        matrixFiles(name));
    Session session(context(), {});
    EXPECT_TRUE(session.open(folder.scene()));
    session.look().setView(view);
    session.drawIfNeeded();
    EXPECT_EQ(text(session.diagnostics()), "");
    return pixelOf(session, 8, 8);
}

Matrix translation(double x, double y, double z) {
    Matrix matrix = kIdentity;
    matrix[12] = x;
    matrix[13] = y;
    matrix[14] = z;
    return matrix;
}

TEST(Transforms, OfTheSceneGoIntoProjectionAlone) {
    ViewState view;
    view.scene = translation(.2, .4, 0);
    EXPECT_EQ(shownMatrix("uProjectionMatrix", view), (Color{51, 102, 0}));
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{0, 0, 0}));
}

TEST(Transforms, OfTheEyeGoIntoModelViewAlone) {
    ViewState view;
    view.eye = translation(.2, .4, .6);
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{51, 102, 153}));
    EXPECT_EQ(shownMatrix("uProjectionMatrix", view), (Color{0, 0, 0}));
}

TEST(Transforms, OfTexturesAreTheFirstTextureMatrix) {
    ViewState view;
    view.texture = translation(.2, .4, .6);
    EXPECT_EQ(shownMatrix("gl_TextureMatrix[0]", view), (Color{51, 102, 153}));
    EXPECT_EQ(shownMatrix("gl_TextureMatrix[1]", view), (Color{0, 0, 0}));
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{0, 0, 0}));
}

TEST(Transforms, OfAnObjectAreItsOwn) {
    ViewState view;
    view.objects = {{6, translation(.2, .4, .6)}};
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{51, 102, 153}));
    view.objects.front().line = 5;
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{0, 0, 0}));
    view.objects = {{DrawId{6, 0, 1}, translation(.2, .4, .6)}};
    EXPECT_EQ(shownMatrix("uModelViewMatrix", view), (Color{0, 0, 0})) << "that line's second draw";
}

TEST(Transforms, SurviveTheTripThroughNumbers) {
    const view::Similarity given{{1, -2, 3}, {20, -35, 110}, 2.5};
    const view::Similarity back = view::similarityOf(view::matrixOf(given));
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(back.translation[i], given.translation[i], 1e-12);
        EXPECT_NEAR(back.degrees[i], given.degrees[i], 1e-10);
    }
    EXPECT_NEAR(back.scale, 2.5, 1e-12);
}

TEST(Transforms, PanningKeepsTheOriginUnderTheMouse) {
    const SceneFolder folder(
        "WindowSize 200 100\nPerspective 50\nLookAt 1 2 6 0 0 0 0 1 0\nColor 1 1 1\nSphere .05\n");
    for (const view::TransformMode mode : {view::TransformMode::eye, view::TransformMode::scene}) {
        Session session(context(), {});
        ASSERT_TRUE(session.open(folder.scene()));
        session.drawIfNeeded();
        EXPECT_EQ(pixelOf(session, 100, 50), (Color{255, 255, 255}));
        session.look().drag(mode, {view::Gesture::pan, {60, 30}, {200, 100}});
        session.drawIfNeeded();
        EXPECT_EQ(pixelOf(session, 160, 20), (Color{255, 255, 255}));
        EXPECT_NE(pixelOf(session, 100, 50), (Color{255, 255, 255}));
    }
}

TEST(Transforms, RotatingKeepsTheOriginInPlaceAndTurnsTheFrontWithTheMouse) {
    const SceneFolder folder(
        "WindowSize 100 100\nPerspective 50\nLookAt 0 0 6 0 0 0 0 1 0\nTranslate 0 0 1\nColor 1 1 1\nSphere "
        ".1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    session.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {50, 0}, {100, 100}});
    session.drawIfNeeded();
    // After a quarter turn the ball in front of the origin is to its right: 1 unit from it, 6 from the eye.
    const int x = 50 + static_cast<int>(50 / std::tan(25 * 3.14159265 / 180) / 6);
    EXPECT_EQ(pixelOf(session, x, 50), (Color{255, 255, 255}));
}

TEST(Projection, OrthographicShowsTheOriginAsLargeAsThePerspectiveDoes) {
    const SceneFolder folder(
        "WindowSize 100 100\nPerspective 40\nLookAt 0 0 7 0 0 0 0 1 0\nColor 1 1 1\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> perspective = pixelsOf(session);
    ViewState view;
    view.projection = ProjectionMode::orthographic;
    session.look().setView(view);
    session.drawIfNeeded();
    EXPECT_EQ(pixelsOf(session), perspective);
    view.eye = translation(0, 0, 3);
    session.look().setView(view);
    session.drawIfNeeded();
    EXPECT_EQ(pixelsOf(session), perspective) << "distance does not matter to an orthographic picture";
}

TEST(Projection, PerspectiveShowsTheMiddleOfABoxAsLargeAsTheBoxDoes) {
    const SceneFolder folder("WindowSize 120 80\nOrtho -1 3 -2 2\nColor 1 1 1\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    const std::vector<std::byte> flat = pixelsOf(session);
    ViewState view;
    view.projection = ProjectionMode::perspective;
    session.look().setView(view);
    session.drawIfNeeded();
    EXPECT_EQ(pixelsOf(session), flat);
}

TEST(Look, ReportsWhatChangesThePicture) {
    int changes = 0;
    view::Look look([&] { ++changes; });
    look.setAxes(true);
    look.setAxes(true);
    EXPECT_EQ(changes, 1);
    look.setNormalLength(.5);
    EXPECT_EQ(changes, 1) << "no normals are shown";
    look.setDebugView(view::DebugView::normals);
    look.setNormalLength(.3);
    EXPECT_EQ(changes, 3);
    look.resize(look.width(), look.height());
    look.setCamera("side");
    EXPECT_EQ(changes, 3) << "there is no scene, and it is as large as before";
    look.setTransform(view::TransformMode::eye, render::asNumbers(glm::dmat4(2)));
    EXPECT_EQ(changes, 4);
    EXPECT_NE(look.view(), ViewState());
    look.resetTransforms();
    EXPECT_EQ(changes, 5);
    EXPECT_EQ(look.view(), ViewState());
}

}  // namespace
}  // namespace glibra::test
