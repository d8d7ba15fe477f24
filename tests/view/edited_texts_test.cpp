// Texts that are compiled before they are saved (Session::setTexts).

#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

const std::string kSmallHead = "WindowSize 20 20\nOrtho -1 1 -1 1 -1 1\n";

std::string constantFragment(std::string_view color) {
    return "#version 330\nout vec4 c;\nvoid main() { c = vec4(" + std::string(color) + ", 1.); }\n";
}

std::array<int, 3> centre(Session& session) {
    session.drawIfNeeded();
    return pixelOf(session, 10, 10);
}

constexpr std::array<int, 3> kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

TEST(EditedTexts, TakeTheShadersPlaceUntilTheyAreGone) {
    const SceneFolder folder(kSmallHead + "Vertex a.vert\nFragment a.frag\nProgram P\nQuadXY 0 1\n",
                             {{"a.vert", kPlainVertex}, {"a.frag", constantFragment("1., 0., 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    EXPECT_EQ(centre(session), kRed);
    session.setTexts({{folder / "a.frag", constantFragment("0., 1., 0.")}});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kGreen);
    EXPECT_EQ(folder.read("a.frag"), constantFragment("1., 0., 0.")) << "nothing is written";
    EXPECT_EQ(session.onlyOnScreen(), "text that is not saved");
    EXPECT_TRUE(session.renderOptions().texts.empty()) << "hardcopies are made from the files";
    // A broken text keeps the last good picture, and its errors have its lines.
    session.setTexts({{folder / "a.frag", "#version 330\nout vec4 c;\n\nvoid main() { oops }\n"}});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kGreen);
    ASSERT_TRUE(hasError(session.diagnostics()));
    EXPECT_EQ(session.diagnostics().front().place.line, 4) << text(session.diagnostics());
    session.setTexts({});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kRed);
    EXPECT_EQ(session.onlyOnScreen(), "");
}

TEST(EditedTexts, TakeThePlaceOfScenesAndOfIncludedFiles) {
    const SceneFolder folder(
        kSmallHead + "Let size <.2 .5 1>\nVertex a.vert\nFragment a.frag\nProgram P\nInclude part.glib\n",
        {{"a.vert", kPlainVertex},
         {"part.glib", "QuadXY 0 1\n"},
         {"color.h", "vec3 color() { return vec3(1., 0., 0.); }\n"},
         {"a.frag",
          "#version 330\n#include \"color.h\"\nout vec4 c;\nvoid main() { c = vec4(color(), 1.); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    EXPECT_EQ(centre(session), kRed) << text(session.diagnostics());
    session.setTexts({{folder / "color.h", "vec3 color() { return vec3(0., 0., 1.); }\n"}});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kBlue) << text(session.diagnostics());
    session.setTexts({{folder / "part.glib", "Translate 5 0 0\nQuadXY 0 1\n"}});
    ASSERT_TRUE(session.reload());
    const std::array<int, 3> background = centre(session);
    EXPECT_NE(background, kRed);
    session.setTexts({{folder.scene(), kSmallHead + "Background 0 1 0\n"}});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kGreen);
}

TEST(EditedTexts, AreForgottenWhenAnotherSceneIsOpened) {
    const SceneFolder folder(kSmallHead + "Color 1 0 0\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.setTexts({{folder.scene(), kSmallHead + "Color 0 1 0\nQuadXY 0 1\n"}});
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(centre(session), kGreen);
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(centre(session), kRed);
}

}  // namespace
}  // namespace glibra::test
