// No command writes over a file that it reads: it ends with file-E13 and status 3, and nothing has changed.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

class Overwriting : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nout vec2 vST;\nvoid main() { vST = aTexCoord0.st; gl_Position = "
                     "uModelViewProjectionMatrix * aVertex; }\n");
        folder.write("a.frag",
                     "#version 330 core\n#include \"light.txt\"\nin vec2 vST;\nuniform sampler2D "
                     "uImage;\nout vec4 f;\nvoid main() { f = light()*texture(uImage, vST); }\n");
        folder.write("light.txt", "float light() { return 1.; }\n");
        folder.write("plain.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .5\n");
        ASSERT_EQ(glibra(folder.path(), "render plain.glib -o plain.png").status, 0);
        fs::copy_file(folder / "plain.png", folder / "wood.png");
        folder.write("b.glib",
                     "WindowSize 16 16\nOrtho -1 1 -1 1\nTexture2D 5 wood.png\nVertex a.vert\n"
                     "Fragment a.frag\nProgram P uImage 5\nQuadXY 0 1\n");
    }

    /// Runs a command that must be refused because of `named`, which stays as it is.
    void refuses(const std::string& arguments, const std::string& named) {
        const std::string before = readFile(folder / named);
        ASSERT_FALSE(before.empty()) << named;
        const Finished run = glibra(folder.path(), arguments);
        EXPECT_EQ(run.status, 3) << arguments << run.out << run.err;
        EXPECT_TRUE(contains(run.err, "[file-E13]")) << arguments << run.err;
        EXPECT_TRUE(readFile(folder / named) == before) << arguments << ": " << named << " has changed";
    }
    bool exists(const std::string& name) { return fs::exists(folder / name); }

    Folder folder;
};

/// The scene wood.glib would be drawn to the texture of the other.
TEST_F(Overwriting, RenderSparesWhatAnotherSceneReads) {
    fs::copy_file(folder / "plain.glib", folder / "wood.glib");
    refuses("render plain.glib wood.glib b.glib -o .", "wood.png");
    refuses("render b.glib --stats b.glib", "b.glib");
    refuses("render b.glib --stats light.txt", "light.txt");
    refuses("render b.glib --stats ./a.frag", "a.frag");
    EXPECT_FALSE(exists("b.png")) << "refused before anything is drawn";
    EXPECT_EQ(glibra(folder.path(), "render plain.glib wood.glib b.glib -o out").status, 0);
    EXPECT_EQ(glibra(folder.path(), "render plain.glib wood.glib b.glib -o out").status, 0) << "once more";
}

TEST_F(Overwriting, ReportsOfATestSpareItsInputs) {
    folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = [\"plain.glib\", \"b.glib\"]\n");
    ASSERT_EQ(glibra(folder.path(), "test s.toml --update --force").status, 0);
    for (const char* each : {"s.toml", "b.glib", "a.vert", "light.txt", "wood.png", "golden/b.png"})
        refuses(std::string("test s.toml --junit ") + each, each);
    fs::create_symlink(folder / "s.toml", folder / "link.xml");
    refuses("test s.toml --junit link.xml", "s.toml");
    EXPECT_EQ(glibra(folder.path(), "test s.toml --results part --junit out.xml").status, 0);
    refuses("test --merge part --junit part/results.jsonl", "part/results.jsonl");
    EXPECT_EQ(glibra(folder.path(), "test --merge part --results part --junit out.xml").status, 0);
}

TEST_F(Overwriting, UpdateSparesTexturesAndGoldensOfOtherSuites) {
    fs::copy_file(folder / "plain.glib", folder / "wood.glib");
    folder.write("s.toml", "goldens = \".\"\n[[shot]]\nscript = [\"wood.glib\", \"b.glib\"]\n");
    refuses("test s.toml --update --force", "wood.png");
    folder.write("one.toml", "goldens = \"golden\"\n[[shot]]\nname = \"x\"\nscript = \"plain.glib\"\n");
    ASSERT_EQ(glibra(folder.path(), "test one.toml --update --force").status, 0);
    folder.write("two.toml", "goldens = \"golden\"\n[[shot]]\nname = \"x\"\nscript = \"b.glib\"\n");
    refuses("test one.toml two.toml --update --force", "golden/x.png");
}

TEST_F(Overwriting, PicturesOfASuiteSpareTexturesAndGoldens) {
    fs::copy_file(folder / "plain.glib", folder / "wood.glib");
    folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = [\"wood.glib\", \"b.glib\"]\n");
    ASSERT_EQ(glibra(folder.path(), "test s.toml --update --force").status, 0);
    refuses("render --suite s.toml -o .", "wood.png");
    refuses("render --suite s.toml -o golden", "golden/b.png");
    EXPECT_EQ(glibra(folder.path(), "render --suite s.toml -o out").status, 0);
    EXPECT_EQ(glibra(folder.path(), "render --suite s.toml -o out").status, 0) << "once more";
}

TEST_F(Overwriting, AHeatMapSparesThePictures) {
    refuses("compare plain.png wood.png --heatmap wood.png", "wood.png");
    refuses("compare plain.png wood.png --heatmap ./plain.png", "plain.png");
    folder.write("one/none.txt", "");
    folder.write("two/none.txt", "");
    for (const char* each : {"one/a.png", "two/a.png"}) fs::copy_file(folder / "plain.png", folder / each);
    refuses("compare one two --heatmap two", "two/a.png");
}

TEST_F(Overwriting, TheFilesOfTheWindowSpareItsScenes) {
    // The files are compared before a display is looked for.
    const std::string before = readFile(folder / "plain.glib");
    for (const char* each : {"--state", "--record"}) {
        const Finished run =
            glibra(folder.path(), std::string("view plain.glib ") + each + " ./plain.glib", "DISPLAY=:none");
        if (contains(run.err, "glibra-view is missing")) GTEST_SKIP() << "this build has no window";
        EXPECT_EQ(run.status, 3) << run.err;
        EXPECT_TRUE(contains(run.err, "[file-E13]")) << run.err;
        EXPECT_EQ(readFile(folder / "plain.glib"), before);
    }
}

/// Its folder of pictures would be a submission of the next run, or replace one of that name.
TEST_F(Overwriting, ThePageOfAClassIsNotWrittenAmongTheSubmissions) {
    folder.write("all/ana/plain.glib", readFile(folder / "plain.glib"));
    for (const char* each : {"all", "all/", "./all/ana/.."}) {
        const Finished run =
            glibra(folder.path(), std::string("class all --reference plain.glib -o ") + each);
        EXPECT_EQ(run.status, 2) << each << run.err;
        EXPECT_TRUE(contains(run.err, "this is the folder of the submissions")) << run.err;
        EXPECT_FALSE(exists("all/index.html")) << each;
    }
}

TEST_F(Overwriting, TranslatedShadersSpareThoseOfTheScene) {
    ASSERT_EQ(glibra(folder.path(), "check b.glib --translated out").status, 0);
    std::string fragment;
    for (const auto& each : fs::directory_iterator(folder / "out"))
        if (each.path().extension() == ".frag") fragment = each.path().filename().string();
    ASSERT_FALSE(fragment.empty());
    folder.write("out/a.vert", readFile(folder / "a.vert"));
    folder.write("out/c.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nVertex a.vert\nFragment \"" + fragment +
                                   "\"\nProgram P\nQuadXY 0 1\n");
    refuses("check out/c.glib --translated out", "out/" + fragment);
}

}  // namespace
}  // namespace glibra::test
