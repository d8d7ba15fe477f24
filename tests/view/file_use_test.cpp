#include "view/edit/source_files.h"

#include "scene_folder.h"
#include "view/session/session.h"

namespace glibra::test {
namespace {

using view::FileUse;

TEST(FileUse, KnowsWhatTheSceneDoesWithAFile) {
    const SceneFolder folder(
        "WindowSize 32 32\nTexture2D 5 shown.ppm\nTexture2D 6 unused.ppm\nVertex a.vert\nFragment a.frag\n"
        "Program P uT 5\nObj tri.obj\n",
        {{"a.vert", kPlainVertex},
         {"a.frag",
          "#version 330\nuniform sampler2D uT; in vec4 vST; out vec4 c;\nvoid main() { c = texture(uT, "
          "vST.st); }\n"},
         {"shown.ppm", "P3 1 1 255 9 8 7\n"},
         {"unused.ppm", "P3 1 1 255 9 8 7\n"},
         {"other.ppm", "P3 1 1 255 9 8 7\n"},
         {"tri.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\n"}});
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    const auto use = [&](const char* name) { return view::useOf(session.live(), folder / name); };
    EXPECT_EQ(use("scene.glib").kind, FileUse::Kind::text);
    EXPECT_EQ(use("a.frag").kind, FileUse::Kind::text);
    EXPECT_EQ(std::filesystem::path(use("a.frag").place.file).filename(), "a.frag");
    EXPECT_EQ(use("shown.ppm").kind, FileUse::Kind::texture) << text(session.diagnostics());
    ASSERT_TRUE(use("shown.ppm").texture);
    EXPECT_NE(session.live().texture(use("shown.ppm").texture), nullptr);
    EXPECT_EQ(use("unused.ppm").kind, FileUse::Kind::data);
    EXPECT_EQ(use("unused.ppm").place.line, 3);
    EXPECT_EQ(use("tri.obj").kind, FileUse::Kind::data);
    EXPECT_EQ(use("tri.obj").place.line, 7);
    EXPECT_EQ(use("other.ppm").kind, FileUse::Kind::none);
    EXPECT_EQ(use("missing.ppm").kind, FileUse::Kind::none);
}

TEST(FileUse, AnotherNameOfTheFileIsTheSameFile) {
    const SceneFolder folder(
        "WindowSize 32 32\nVertex a.vert\nFragment a.frag\nProgram P\nSphere 1\n",
        {{"a.vert", kPlainVertex}, {"a.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); }\n"}});
    view::Session session(context(), {});
    ASSERT_TRUE(session.open(folder.scene())) << text(session.diagnostics());
    std::filesystem::create_symlink(folder / "a.frag", folder / "link.frag");
    EXPECT_EQ(view::useOf(session.live(), folder / "link.frag").kind, FileUse::Kind::text);
}

}  // namespace
}  // namespace glibra::test
