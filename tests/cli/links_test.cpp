// Files and folders whose names glibra chooses itself are never written through links. Only a name that the
// user gave may be one.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

class Links : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .5\n");
        folder.write("s.toml", "[[shot]]\nscript = \"a.glib\"\n");
        elsewhere.write("precious", "kept");
    }
    /// A link of that name to a file of somebody else.
    void linkFile(const std::string& name) const {
        fs::create_directories((folder / name).parent_path());
        fs::remove(folder / name);
        fs::create_symlink(elsewhere / "precious", folder / name);
    }
    /// A link of that name to a folder of somebody else.
    void linkFolder(const std::string& name) const {
        fs::create_directories((folder / name).parent_path());
        fs::create_directory_symlink(elsewhere.path(), folder / name);
    }
    void expectKept(const std::string& after) const {
        EXPECT_EQ(elsewhere.listing(), "precious\n") << after;
        EXPECT_EQ(readFile(elsewhere / "precious"), "kept") << after;
    }
    Finished run(const std::string& arguments) const { return glibra(folder.path(), arguments); }

    Folder folder, elsewhere;
};

TEST_F(Links, OfPicturesAreReplaced) {
    struct Case {
        std::string command, file;
    };
    for (const Case& each :
         {Case{"render a.glib", "a.png"}, Case{"render a.glib -o out/", "out/a.png"},
          Case{"render - < a.glib -o out/", "out/stdin.png"},
          Case{"render a.glib --frames 2 -o f.png", "f_0001.png"}, Case{"render --suite s.toml", "s/a.png"},
          Case{"render --suite s.toml -o drawn", "drawn/a.png"},
          Case{"test s.toml --report report", "report/index.html"},
          Case{"test s.toml", "glibra-results/results.jsonl"},
          Case{"test s.toml --update --force", "golden/s.hashes"}}) {
        linkFile(each.file);
        run(each.command);
        expectKept(each.command);
    }
    for (const char* each : {"a.png", "out/a.png", "f_0001.png", "s/a.png", "drawn/a.png"}) {
        EXPECT_FALSE(fs::is_symlink(folder / each)) << each;
        EXPECT_GT(fs::file_size(folder / each), 50U) << each;
    }
}

TEST_F(Links, OfPicturesAreReplacedByConfinedWorkersToo) {
    if (run("render a.glib -o x.png --untrusted").status == 4) GTEST_SKIP() << "no sandbox";
    for (const std::string each : {"a.png", "out/a.png"}) {
        linkFile(each);
        EXPECT_EQ(run("render a.glib --untrusted" + std::string(each == "a.png" ? "" : " -o out/")).status,
                  0);
        EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / each)));
        expectKept(each);
    }
}

TEST_F(Links, ThatTheUserNamesKeepTheirTargets) {
    folder.write("old.png", "old");
    for (const std::string more : {"", " --untrusted"}) {
        fs::remove(folder / "link.png");
        fs::create_symlink("old.png", folder / "link.png");
        const Finished done = run("render a.glib -o link.png" + more);
        if (done.status == 4) continue;
        EXPECT_EQ(done.status, 0) << done.err;
        EXPECT_TRUE(fs::is_symlink(folder / "link.png"));
        EXPECT_GT(fs::file_size(folder / "old.png"), 50U);
    }
    fs::create_directory(folder / "real");
    fs::create_directory_symlink("real", folder / "named");
    EXPECT_EQ(run("render a.glib -o named/").status, 0);
    EXPECT_TRUE(fs::exists(folder / "real/a.png"));
    EXPECT_EQ(run("test s.toml --results named --update --force").status, 0);
    EXPECT_TRUE(fs::exists(folder / "real/results.jsonl"));
}

TEST_F(Links, OfFoldersAreRefused) {
    linkFolder("glibra-results");
    const Finished tested = run("test s.toml");
    EXPECT_EQ(tested.status, 3) << tested.out << tested.err;
    EXPECT_TRUE(contains(tested.err, "--results")) << tested.err;
    expectKept("test");
    linkFolder("results/s");
    run("test s.toml --results results");
    expectKept("test --results results");
    linkFolder("s");
    EXPECT_EQ(run("render --suite s.toml").status, 3);
    expectKept("render --suite");
    folder.write("n.toml", "[[shot]]\nname = \"deep/a\"\nscript = \"a.glib\"\n");
    linkFolder("drawn/deep");
    EXPECT_EQ(run("render --suite n.toml -o drawn").status, 3);
    expectKept("render --suite -o drawn");
    linkFolder("glibra-class");
    folder.write("all/ana/a.glib", "Sphere .5\n");
    const Finished classed = run("class all --reference a.glib");
    EXPECT_EQ(classed.status, 3) << classed.err;
    EXPECT_TRUE(contains(classed.err, "-o")) << classed.err;
    expectKept("class");
    // Scenes of one name lie in folders of their own.
    folder.write("x/a.glib", "Sphere .5\n");
    folder.write("y/a.glib", "Sphere .5\n");
    linkFolder("out/y");
    EXPECT_EQ(run("render x/a.glib y/a.glib -o out").status, 3);
    expectKept("render of two scenes");
}

TEST_F(Links, OfTranslatedShadersAreReplaced) {
    ASSERT_EQ(run("check a.glib --translated first").status, 0);
    for (const fs::directory_entry& each : fs::directory_iterator(folder / "first"))
        linkFile("second/" + each.path().filename().string());
    EXPECT_EQ(run("check a.glib --translated second").status, 0);
    expectKept("check");
}

}  // namespace
}  // namespace glibra::test
