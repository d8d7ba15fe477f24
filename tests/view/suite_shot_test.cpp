#include "view/export/hardcopy.h"

#include "render/scene_renderer.h"
#include "scene_folder.h"
#include "suite/file/suite_file.h"

namespace glibra::test {
namespace {

using view::Session;

/// Renders the only shot of a suite to RGB.
std::vector<std::byte> shotPicture(const std::filesystem::path& file, Diagnostics& problems) {
    const auto read = suite::readSuite(file);
    append(problems, read.diagnostics);
    if (!read || read->shots.size() != 1) return {};
    render::Stats stats;
    auto loaded =
        render::SceneRenderer::load(context(), read->shots[0].script, read->shots[0].options, stats);
    append(problems, loaded.diagnostics);
    if (!loaded) return {};
    auto picture = loaded->draw(read->shots[0].options.time, stats);
    append(problems, picture.diagnostics);
    return picture ? std::move(picture->data) : std::vector<std::byte>();
}

TEST(SuiteShot, GivesThePixelsOfTheScreen) {
    const SceneFolder folder("");
    Session session(context(), {});
    ASSERT_TRUE(session.open(GLIBRA_SOURCE_DIR "/glib/patterns/ovalnoise.glib"));
    session.look().resize(300, 200);
    changeOvalNoise(session, 150, 110);
    session.drawIfNeeded();
    const Diagnostics problems = view::appendShot(folder / "s.toml", "turned", session);
    ASSERT_TRUE(problems.empty()) << text(problems);
    Diagnostics said;
    const std::vector<std::byte> picture = shotPicture(folder / "s.toml", said);
    ASSERT_FALSE(picture.empty()) << text(said) << folder.read("s.toml");
    EXPECT_TRUE(picture == pixelsOf(session)) << folder.read("s.toml");
}

constexpr const char* kFragment =
    "#version 330\nuniform float uR; uniform bool uB; out vec4 c;\nvoid main() { c = vec4(uR, uB, 0., 1.); "
    "}\n";
constexpr const char* kTwoPrograms =
    "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uR <0 .2 1> uB <false>\n"
    "QuadXY 0 1\nProgram P uR <0 .4 1>\nQuadXY .5 .5\n";

TEST(SuiteShot, KnowsWhichProgramAValueBelongsTo) {
    const SceneFolder folder(kTwoPrograms, {{"a.vert", kPlainVertex}, {"a.frag", kFragment}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.clock().setTime(3);
    EXPECT_EQ(view::shotText(session, "still", ".").find("time"), std::string::npos) << "nothing reads it";
    session.values().set(2, {.75});
    ASSERT_EQ(session.values().knobs().at(2).tag, "uR");
    session.values().set(knobIndex(session, "uB"), {1});
    session.drawIfNeeded();
    ASSERT_TRUE(view::appendShot(folder / "s.toml", "two", session).empty());
    EXPECT_NE(folder.read("s.toml").find("\"5:uB\" = true, \"7:uR\" = \"0.75\""), std::string::npos)
        << folder.read("s.toml");
    Diagnostics said;
    EXPECT_TRUE(shotPicture(folder / "s.toml", said) == pixelsOf(session)) << text(said);
}

TEST(SuiteShot, IsAddedBelowWhatTheFileHasAndNeverTwiceUnderOneName) {
    const std::string before = "# mine\n[[shot]]\nscript = \"scene.glib\"\nname = 'first'";
    const SceneFolder folder(kTwoPrograms,
                             {{"a.vert", kPlainVertex}, {"a.frag", kFragment}, {"s.toml", before}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(view::freeShotName(folder / "s.toml", session), "scene");
    EXPECT_TRUE(view::appendShot(folder / "s.toml", "scene", session).empty());
    const std::string after = folder.read("s.toml");
    EXPECT_TRUE(after.starts_with(before + "\n\n[[shot]]\nname = \"scene\"\nscript = \"scene.glib\"\n"))
        << after;
    EXPECT_EQ(view::freeShotName(folder / "s.toml", session), "scene-2");

    for (const char* name : {"scene", "first", "not a name"})
        EXPECT_FALSE(view::appendShot(folder / "s.toml", name, session).empty()) << name;
    EXPECT_EQ(folder.read("s.toml"), after);
    folder.write("s.toml", "[[shot]\n");
    EXPECT_FALSE(view::appendShot(folder / "s.toml", "third", session).empty());
    EXPECT_EQ(folder.read("s.toml"), "[[shot]\n");
}

TEST(SuiteShot, NamesWhatItLeavesOutOfTheScreen) {
    const SceneFolder folder("WindowSize 16 16\nSphere 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    EXPECT_EQ(view::shotText(session, "ball", ".").find('#'), std::string::npos);
    session.look().setWireframe(true);
    session.look().setDebugView(view::DebugView::depth);
    session.drawIfNeeded();
    EXPECT_EQ(session.onlyOnScreen(), "wireframe and the debug view 'depth'");
    ASSERT_TRUE(view::appendShot(folder / "s.toml", "ball", session).empty());
    EXPECT_NE(folder.read("s.toml").find("without wireframe and the debug view 'depth'"), std::string::npos)
        << folder.read("s.toml");
    session.look().setWireframe(false);
    session.look().setDebugView(view::DebugView::picture);
    session.drawIfNeeded();
    Diagnostics said;
    EXPECT_TRUE(shotPicture(folder / "s.toml", said) == pixelsOf(session)) << text(said);
}

TEST(SuiteShot, StrangeNamesOfFilesAreQuoted) {
    const SceneFolder folder("");
    folder.write("a \"b\" [c].glib", "WindowSize 16 16\nSphere 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder / "a \"b\" [c].glib"));
    session.drawIfNeeded();
    const std::string name = view::freeShotName(folder / "s.toml", session);
    const Diagnostics problems = view::appendShot(folder / "s.toml", name, session);
    EXPECT_TRUE(problems.empty()) << text(problems) << name;
}

}  // namespace
}  // namespace glibra::test
