#include <filesystem>

#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

std::string knobFragment(const std::string& expression) {
    return "#version 330\nuniform float uR; uniform float uG; out vec4 c;\nvoid main() { c = vec4(" +
           expression + ", 1.); }\n";
}
const std::string kReloadedScene =
    "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uR <0 .2 1> uG <0 .4 1>\n"
    "QuadXY 0 1\n";

TEST(Reload, ShowsAnEditedShaderWithTheValuesAsTheyWere) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {.8});
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{204, 102, 0}));
    folder.write("a.frag", knobFragment("uG, uR, 1."));
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{102, 204, 255}));
}

TEST(Reload, KeepsTheLastGoodProgramAndReportsTheError) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {.8});
    for (int i = 0; i < 3; ++i) {
        folder.write("a.frag", knobFragment("uR, oops, 0."));
        ASSERT_TRUE(session.reload());
        session.drawIfNeeded();
        EXPECT_EQ(pixelOf(session, 8, 8), (Color{204, 102, 0}));
        EXPECT_TRUE(session.live().showsEarlierProgram(scene::ProgramIndex(0)));
        ASSERT_TRUE(hasError(session.diagnostics()));
        EXPECT_EQ(session.diagnostics().front().place.line, 3) << text(session.diagnostics());
        EXPECT_NE(session.diagnostics().front().text.find("oops"), std::string::npos);
    }
    session.values().set(knobIndex(session, "uG"), {1});
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{204, 255, 0})) << "its values can still be changed";
    folder.write("a.frag", knobFragment("0., uG, 1."));
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{0, 255, 255}));
    EXPECT_FALSE(session.live().showsEarlierProgram(scene::ProgramIndex(0)));
    EXPECT_FALSE(hasError(session.diagnostics()));
}

TEST(Reload, AnEmptyOrMissingShaderCountsAsFailing) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    folder.write("a.frag", "");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{51, 102, 0}));
    EXPECT_TRUE(hasError(session.diagnostics()));
    std::filesystem::remove(folder / "a.frag");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{51, 102, 0}));
    EXPECT_TRUE(hasError(session.diagnostics()));
}

TEST(Reload, OfASceneKeepsValuesWhoseSpecificationIsUnchanged) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.values().set(knobIndex(session, "uR"), {.8});
    session.values().set(knobIndex(session, "uG"), {1});
    folder.write(
        "scene.glib",
        "# moved down\nWindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uR <0 .2 "
        "1> uG <0 .6 1>\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(session.values().knob("", "uR")->current.front(), .8);
    EXPECT_EQ(session.values().knob("", "uG")->current.front(), .6);
}

/// A scene of programs, each with a uniform uR at .25, in that order.
std::string programsScene(const std::vector<std::string>& names) {
    std::string text = "WindowSize 20 20\nOrtho -1 1 -1 1 -1 1\n";
    for (const std::string& each : names)
        text += "Vertex a.vert\nFragment a.frag\nProgram " + each + " uR <0 .25 1>\nQuadXY 0 .2\n";
    return text;
}

TEST(Reload, ValuesGoWithTheirProgramsWhenOthersAreInsertedRemovedOrRenamed) {
    const SceneFolder folder(
        programsScene({"A", "B", "A"}),
        {{"a.vert", kPlainVertex},
         {"a.frag", "#version 330\nuniform float uR; out vec4 c;\nvoid main() { c = vec4(uR); }\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ASSERT_EQ(session.values().knobs().size(), 3U);
    session.values().set(0, {.5});
    session.values().set(1, {.6});
    session.values().set(2, {.7});
    session.values().animate(1, true);
    const auto valuesWith = [&](const std::vector<std::string>& names) {
        folder.write("scene.glib", programsScene(names));
        EXPECT_TRUE(session.reload());
        std::vector<double> values;
        for (std::size_t i = 0; i < session.values().knobs().size(); ++i)
            values.push_back(session.values().resting(i).front());
        return values;
    };
    using Values = std::vector<double>;
    EXPECT_EQ(valuesWith({"New", "A", "B", "A"}), (Values{.25, .5, .6, .7}));
    EXPECT_TRUE(session.values().isAnimated(2)) << "an animation goes with its program";
    EXPECT_EQ(valuesWith({"New", "A", "Renamed", "A"}), (Values{.25, .5, .6, .7}));
    EXPECT_EQ(valuesWith({"A", "Renamed", "A"}), (Values{.5, .6, .7}));
    EXPECT_EQ(valuesWith({"A", "A"}), (Values{.5, .7}));
    EXPECT_EQ(valuesWith({"A", "Renamed", "A", "A"}), (Values{.5, .6, .7, .25}));
    EXPECT_EQ(valuesWith({"First", "Second", "Third", "A"}), (Values{.25, .25, .25, .5}))
        << "another order of names is no renaming";
}

TEST(Reload, ATagThatIsGoneGivesTheUniformItsFirstValueBack) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{51, 102, 0}));
    folder.write("scene.glib",
                 "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram P uR <0 .2 "
                 "1>\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{51, 0, 0}));
}

TEST(Reload, CompilesOnlyWhatChanged) {
    const SceneFolder folder(
        "WindowSize 16 16\nOrtho -2 2 -1 1\nVertex a.vert\nFragment a.frag\nProgram A uR .2\n"
        "QuadXY 0 1\nFragment b.frag\nProgram B uR .2\nSphere 1 60 60\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", knobFragment("uR, uG, 0.")},
         {"b.frag", knobFragment("0., uR, uG")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    const auto count = [&](std::string_view name) {
        for (const render::Stats::Count& each : session.live().loadStats().counts)
            if (each.name == name) return each.value;
        return std::uint64_t{0};
    };
    EXPECT_EQ(count("programs"), 2U);
    EXPECT_EQ(count("meshes"), 2U);
    folder.write("b.frag", knobFragment("1., uR, uG"));
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(count("programs"), 1U);
    EXPECT_EQ(count("meshes"), 0U);
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(count("programs"), 0U);
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{255, 51, 0})) << text(session.diagnostics());
}

TEST(Reload, ReadsAnEditedIncludeAndTextureAndModel) {
    const std::string sampled =
        "#version 330\n#include \"tint.glsl\"\nuniform sampler2D uT; in vec4 vST; out vec4 c;\n"
        "void main() { c = vec4(texture(uT, vST.st).rgb * tint(), 1.); }\n";
    const auto bmp = [](unsigned char red) {
        std::string bytes(
            "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0\0\0\0\0\4\0\0\0", 38);
        bytes += std::string(16, '\0');
        bytes += std::string{'\0', '\0', static_cast<char>(red), '\0'};
        return bytes;
    };
    const SceneFolder folder(
        "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nTexture2D 5 p.bmp\nProgram P uT "
        "5\n"
        "Obj m.obj\n",
        {{"a.vert", kPlainVertex},
         {"a.frag", sampled},
         {"tint.glsl", "vec3 tint() { return vec3(1.); }\n"},
         {"p.bmp", bmp(200)},
         {"m.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{200, 0, 0})) << text(session.diagnostics());
    bool watchesInclude = false;
    for (const auto& each : session.live().files())
        watchesInclude = watchesInclude || each.filename() == "tint.glsl";
    EXPECT_TRUE(watchesInclude);

    folder.write("p.bmp", bmp(100));
    std::filesystem::last_write_time(
        folder / "p.bmp", std::filesystem::last_write_time(folder / "p.bmp") + std::chrono::seconds(1));
    session.reload();
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{100, 0, 0}));

    folder.write("tint.glsl", "vec3 tint() { return vec3(.5); }\n");
    session.reload();
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{50, 0, 0}));

    folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n# longer\n");
    session.reload();
    session.drawIfNeeded();
    EXPECT_EQ(pixelOf(session, 12, 4), (Color{50, 0, 0}));
    EXPECT_EQ(pixelOf(session, 4, 12), (Color{18, 27, 33})) << "background";

    std::filesystem::remove(folder / "p.bmp");
    session.reload();
    session.drawIfNeeded();
    EXPECT_TRUE(hasError(session.diagnostics()));
    EXPECT_NE(text(session.diagnostics()).find("p.bmp"), std::string::npos) << text(session.diagnostics());
    EXPECT_EQ(pixelOf(session, 12, 4), (Color{0, 0, 0})) << "what a missing texture reads";
}

TEST(Reload, ASceneThatIsGoneLeavesWhatIsShown) {
    const SceneFolder folder(kReloadedScene,
                             {{"a.vert", kPlainVertex}, {"a.frag", knobFragment("uR, uG, 0.")}});
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    session.drawIfNeeded();
    std::filesystem::remove(folder.scene());
    EXPECT_FALSE(session.reload());
    session.look().resize(20, 20);
    EXPECT_TRUE(session.drawIfNeeded());
    EXPECT_EQ(pixelOf(session, 8, 8), (Color{51, 102, 0}));
    folder.write("scene.glib", kReloadedScene);
    EXPECT_TRUE(session.reload());
    EXPECT_FALSE(hasError(session.diagnostics()));
}

TEST(Reload, TransformsOfObjectsFollowTheirStatement) {
    const SceneFolder folder("WindowSize 16 16\nOrtho -1 1 -1 1\nColor 1 0 0\nQuadXY 0 1\n");
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    ViewState view;
    Matrix moved = kIdentity;
    moved[12] = 1;
    view.objects = {{4, moved}};
    session.look().setView(view);
    folder.write("scene.glib", "WindowSize 16 16\n\n\nOrtho -1 1 -1 1\nColor 1 0 0\nQuadXY 0 1\n");
    ASSERT_TRUE(session.reload());
    ASSERT_EQ(session.look().view().objects.size(), 1U);
    EXPECT_EQ(session.look().view().objects.front().line, 6);
}

}  // namespace
}  // namespace glibra::test
