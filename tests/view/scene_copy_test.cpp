// Copies of scenes, examples, and files that the user chooses.

#include "view/edit/saved_scene.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "scene_folder.h"
#include "view/browse/example_scenes.h"
#include "view/edit/edited_file.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;
using view::Session;

constexpr const char* kCopiedFragment =
    "#version 330\n#include \"lib/flat.glsl\"\nuniform float uR; out vec4 c;\n"
    "void main() { c = flatColor(uR); }\n";
constexpr const char* kCopiedInclude = "vec4 flatColor(float r) { return vec4(r, .5, 0., 1.); }\n";
constexpr const char* kCopiedScene =
    "WindowSize 32 32\nOrtho -1 1 -1 1\nVertex a.vert\nFragment a.frag\nProgram Flat uR <0 .2 1>\nQuadXY 0 "
    "1\n";
const std::map<std::string, std::string> kCopiedFiles{
    {"a.vert", kPlainVertex}, {"a.frag", kCopiedFragment}, {"lib/flat.glsl", kCopiedInclude}};
constexpr const char* kTriangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Opens and draws.
void openAndDraw(Session& session, const fs::path& scene) {
    ASSERT_TRUE(session.open(scene)) << text(session.diagnostics());
    session.look().resize(120, 90);
    session.drawIfNeeded();
    EXPECT_FALSE(hasError(session.diagnostics())) << text(session.diagnostics());
}

TEST(SceneCopy, OfEveryExerciseIsComplete) {
    const SceneFolder folder("");
    int count = 0;
    for (const view::ExampleScene& each : view::exampleScenes(GLIBRA_SOURCE_DIR)) {
        if (!each.topic.starts_with("exercises/")) continue;
        ++count;
        Session original(context(), {}), copy(context(), {});
        ASSERT_TRUE(original.open(each.file)) << each.file;
        const fs::path target = folder / (each.topic + "_" + each.name + "/mine.glib");
        const Diagnostics problems = view::writeCopy(contentOf(each.file), target,
                                                     view::filesOfCopy(original.live(), target, true, {}));
        ASSERT_TRUE(problems.empty()) << text(problems);
        EXPECT_TRUE(copy.open(target)) << each.file << text(copy.diagnostics());
        EXPECT_FALSE(hasError(copy.diagnostics())) << each.file << text(copy.diagnostics());
    }
    EXPECT_GT(count, 60);
}

TEST(SceneCopy, OfAnExampleIsCompleteAndShowsTheSame) {
    const SceneFolder folder("");
    int count = 0;
    for (const view::ExampleScene& each : view::exampleScenes(GLIBRA_SOURCE_DIR)) {
        if (each.topic != "start" && each.name != "fountain" && each.name != "flat_water") continue;
        ++count;
        Session original(context(), {}), copy(context(), {});
        openAndDraw(original, each.file);
        const fs::path target = folder / (each.name + "/mine.glib");
        const auto files = view::filesOfCopy(original.live(), target, true, {});
        EXPECT_FALSE(files.empty()) << each.name;
        const Diagnostics problems = view::writeCopy(contentOf(each.file), target, files);
        ASSERT_TRUE(problems.empty()) << text(problems);
        openAndDraw(copy, target);
        EXPECT_TRUE(pixelsOf(original) == pixelsOf(copy)) << each.name;
        for (const fs::path& file : copy.live().files())
            EXPECT_TRUE(file.string().starts_with(target.parent_path().string())) << file;
    }
    EXPECT_GE(count, 5);
}

TEST(SceneCopy, KeepsTheFoldersOfIncludedFiles) {
    const SceneFolder folder(kCopiedScene, kCopiedFiles);
    Session original(context(), {}), copy(context(), {});
    openAndDraw(original, folder.scene());
    const fs::path target = folder / "deep/er/b.glib";
    ASSERT_TRUE(
        view::writeCopy(kCopiedScene, target, view::filesOfCopy(original.live(), target, false, {})).empty());
    EXPECT_EQ(contentOf(folder / "deep/er/lib/flat.glsl"), kCopiedInclude);
    openAndDraw(copy, target);
    EXPECT_TRUE(pixelsOf(original) == pixelsOf(copy));
}

TEST(SceneCopy, InTheSameFolderNeedsNoFiles) {
    const SceneFolder folder(kCopiedScene, kCopiedFiles);
    Session original(context(), {});
    openAndDraw(original, folder.scene());
    EXPECT_TRUE(view::filesOfCopy(original.live(), folder / "b.glib", false, {}).empty());
}

TEST(SceneCopy, ReplacesNoOtherFile) {
    const SceneFolder folder(kCopiedScene, kCopiedFiles);
    folder.write("there/a.frag", "somebody's work");
    Session original(context(), {});
    openAndDraw(original, folder.scene());
    const fs::path target = folder / "there/b.glib";
    const Diagnostics problems =
        view::writeCopy(kCopiedScene, target, view::filesOfCopy(original.live(), target, true, {}));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(problems.front().text.find("choose an empty folder"), std::string::npos);
    EXPECT_EQ(folder.read("there/a.frag"), "somebody's work");
    EXPECT_FALSE(fs::exists(target));
    EXPECT_FALSE(fs::exists(folder / "there/a.vert"));
}

TEST(Examples, AreNotWrittenTo) {
    const fs::path scene = fs::path(GLIBRA_SOURCE_DIR) / "glib/patterns/ovalnoise.glib";
    EXPECT_TRUE(view::isExample(scene));
    EXPECT_TRUE(view::isExample(fs::path(GLIBRA_SOURCE_DIR) / "shaders/start/glaze.frag"));
    EXPECT_FALSE(view::isExample(fs::path(GLIBRA_SOURCE_DIR) / "docs/examples/a.glib"));
    const std::string before = contentOf(scene);
    Session session(context(), {});
    ASSERT_TRUE(session.open(scene));
    session.values().set(knobIndex(session, "uAd"), {.4});
    const Diagnostics problems = view::saveValues(session.path(), session.values().knobs());
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().id, "view-E03");
    EXPECT_EQ(contentOf(scene), before);
    EXPECT_NE(view::EditedFile(scene).whyReadOnly().find("save a copy"), std::string::npos);
    const SceneFolder folder(kCopiedScene, kCopiedFiles);
    EXPECT_FALSE(view::isExample(folder.scene()));
    EXPECT_EQ(view::EditedFile(folder.scene()).whyReadOnly(), "");
}

TEST(Examples, HaveTheirBookAndChapter) {
    const auto scenes = view::exampleScenes(GLIBRA_SOURCE_DIR);
    const auto of = [&](const char* name) {
        const auto found = std::find_if(scenes.begin(), scenes.end(),
                                        [&](const view::ExampleScene& each) { return each.name == name; });
        return found == scenes.end() ? std::string("missing") : found->source;
    };
    EXPECT_EQ(of("ovalnoise"), "Graphics Shaders, chapters 4, 8 and 9");
    EXPECT_EQ(of("planets"), "OpenGL with Java, chapter 4");
    EXPECT_EQ(of("cloth"), "");
    for (const view::ExampleScene& each : scenes) {
        const std::string first = each.summary.substr(0, each.summary.find(' '));
        EXPECT_EQ(first.find_first_of("0123456789"), std::string::npos) << each.summary;
    }
}

TEST(ChosenFiles, AreUsedAndSavedIntoTheScene) {
    const SceneFolder folder(
        "WindowSize 32 32\nOrtho -1 1 -1 1\r\nVertex a.vert\nFragment a.frag\nProgram Flat uR <0 .2 1>\n"
        "  Obj   # a model\nObj\n",
        kCopiedFiles);
    folder.write("models/a.obj", kTriangle);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    const auto missing = [&] {
        std::vector<Place> places;
        for (const Diagnostic& each : session.diagnostics())
            if (each.id == "glib-E09") places.push_back(each.place);
        return places;
    };
    ASSERT_EQ(missing().size(), 2U) << text(session.diagnostics());
    EXPECT_EQ(session.chooseFile(missing().back(), folder / "models/a.obj"), "");
    ASSERT_TRUE(session.reload());
    ASSERT_EQ(missing().size(), 1U);
    EXPECT_EQ(missing().front().line, 6);
    EXPECT_EQ(session.chooseFile(missing().front(), "/none/b \xC3\xBC.obj"), "");
    session.values().set(knobIndex(session, "uR"), {.5});
    const Diagnostics problems =
        view::saveValues(session.path(), session.values().knobs(), session.chosenFiles());
    ASSERT_TRUE(problems.empty()) << text(problems);
    EXPECT_EQ(folder.read("scene.glib"),
              "WindowSize 32 32\nOrtho -1 1 -1 1\r\nVertex a.vert\nFragment a.frag\nProgram Flat uR <0 0.5 "
              "1>\n  Obj \"/none/b \xC3\xBC.obj\"   # a model\nObj \"models/a.obj\"\n");
}

TEST(ChosenFiles, FollowTheirStatementsWhenLinesMove) {
    const std::string before = "Obj\nSphere\nObj\n";
    const auto chosen = view::chosenFile(before, {"/a/s.glib", 3, 1}, "/a/b.obj");
    ASSERT_TRUE(chosen);
    EXPECT_EQ(view::withFiles("# one\n# two\nObj\nObj\n", std::span(&*chosen, 1)),
              "# one\n# two\nObj\nObj \"b.obj\"\n");
    EXPECT_EQ(view::withFiles("Obj x.obj\n", std::span(&*chosen, 1)), "Obj x.obj\n");
    EXPECT_FALSE(view::chosenFile(before, {"/a/s.glib", 9, 1}, "/a/b.obj"));
}

TEST(Verbose, ReportsEachStatementOnlyWhileItIsOn) {
    const SceneFolder folder(kCopiedScene, kCopiedFiles);
    Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene()));
    const auto reported = [&] {
        return std::count_if(session.diagnostics().begin(), session.diagnostics().end(),
                             [](const Diagnostic& each) { return each.id == "glib-N02"; });
    };
    EXPECT_EQ(reported(), 0);
    session.setVerbose(true);
    ASSERT_TRUE(session.reload());
    EXPECT_GE(reported(), 5) << text(session.diagnostics());
    session.setVerbose(false);
    ASSERT_TRUE(session.reload());
    EXPECT_EQ(reported(), 0);
}

}  // namespace
}  // namespace glibra::test
