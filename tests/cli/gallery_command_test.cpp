// `glibra gallery`, run as a user runs it.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image/read.h"
#include "program.h"
#include "system/sandbox.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMovingFragment =
    "#version 330\nuniform float uG; out vec4 c;\nvoid main() { c = vec4(Timer, uG, 0., 1.); }\n";
constexpr const char* kStillFragment =
    "#version 330\n// timeless\nout vec4 c;\nvoid main() { c = vec4(1.); }\n";

std::string scene(const std::string& fragment) {
    return "# A quad.\nWindowSize 40 30\nOrtho -1 1 -1 1\nTimer 2\nVertex q.vert\nFragment " + fragment +
           "\nProgram P uG <0. .5 1.>\nQuadXY 0 1\n";
}

class GalleryCommand : public testing::Test {
  protected:
    GalleryCommand() {
        for (const char* each : {"in/moves/q.vert", "in/still/q.vert"}) folder.write(each, kVertexShader);
        folder.write("in/moves/a.frag", kMovingFragment);
        folder.write("in/still/b.frag", kStillFragment);
        folder.write("in/moves/a.glib", scene("a.frag"));
        folder.write("in/still/b.glib", scene("b.frag"));
    }
    [[nodiscard]] Finished gallery(const std::string& more = "-o site",
                                   const std::string& environment = {}) const {
        return glibra(folder.path(), "gallery in " + more, environment);
    }
    /// Files of the site, sorted.
    [[nodiscard]] std::string site() const {
        std::vector<std::string> names;
        for (const auto& each : fs::recursive_directory_iterator(folder / "site"))
            if (!each.is_directory())
                names.push_back(each.path().lexically_relative(folder / "site").generic_string());
        std::sort(names.begin(), names.end());
        std::string text;
        for (const std::string& each : names) text += each + "\n";
        return text;
    }
    Folder folder;
};

constexpr const char* kWholeSite =
    ".glibra-gallery\nfilms/moves-a.png\ngallery.css\ngallery.js\nindex.html\npictures/moves-a.png\n"
    "pictures/still-b.png\nscenes/moves-a.html\nscenes/still-b.html\n";

TEST_F(GalleryCommand, WritesPagesPicturesAndFilmsAndNothingElse) {
    const Finished run = gallery();
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(run.err, "2 scenes: 2 drawn")) << run.err;
    EXPECT_EQ(site(), kWholeSite);
    const std::string index = readFile(folder / "site/index.html");
    EXPECT_TRUE(contains(index, "data-film=\"films/moves-a.png\""));
    EXPECT_TRUE(contains(index, "<title>in</title>"));
    EXPECT_FALSE(contains(readFile(folder / "site/scenes/still-b.html"), "films/"));
    const auto picture = image::readImage(folder / "site/pictures/still-b.png");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 400);
    const auto film = image::readImage(folder / "site/films/moves-a.png");
    ASSERT_TRUE(film);
    EXPECT_EQ(film->height, 150);
}

TEST_F(GalleryCommand, TakesTitleSizeAndJobs) {
    const Finished run = gallery("-o site --title 'Week <3>' --size 200x60 --jobs 1");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(readFile(folder / "site/index.html"), "<title>Week &lt;3&gt;</title>"));
    const auto picture = image::readImage(folder / "site/pictures/still-b.png");
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 80) << "the shape of the window, in the given size";
    EXPECT_EQ(picture->height, 60);
}

TEST_F(GalleryCommand, ABrokenSceneHasAPageWithItsMessage) {
    folder.write("in/c.glib", "# Broken.\nVertex none.vert\nFragment none.frag\nProgram P\nSphere\n");
    folder.write("in/e.glib", "");
    const Finished run = gallery();
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.err, "c.glib: failed")) << run.err;
    const std::string page = readFile(folder / "site/scenes/c.html");
    EXPECT_TRUE(contains(page, "none.vert")) << page;
    EXPECT_TRUE(contains(page, "file-E01")) << page;
    EXPECT_TRUE(contains(readFile(folder / "site/index.html"), "scenes/moves-a.html"));
}

TEST_F(GalleryCommand, WritesOnlyIntoAFolderOfItsOwn) {
    folder.write("site/pictures/holiday.png", "mine");
    for (const char* each : {"-o site", "-o in", "-o .", "-o in/moves/a.glib"}) {
        const Finished run = gallery(each);
        EXPECT_EQ(run.status, 2) << each << run.err;
        EXPECT_TRUE(contains(run.err, "name another one") || contains(run.err, "not a folder")) << run.err;
    }
    EXPECT_EQ(site(), "pictures/holiday.png\n");
    EXPECT_EQ(glibra(folder.path(), "gallery none -o x").status, 2);
    fs::create_directory(folder / "empty");
    EXPECT_EQ(glibra(folder.path(), "gallery empty -o x").status, 3);
    EXPECT_FALSE(fs::exists(folder / "x"));
}

TEST_F(GalleryCommand, ReplacesAnEarlierSiteEvenInsideOfTheFolder) {
    folder.write("in/gone.glib", scene("a.frag"));
    fs::copy(folder / "in/moves/q.vert", folder / "in/q.vert");
    fs::copy(folder / "in/moves/a.frag", folder / "in/a.frag");
    ASSERT_EQ(gallery("-o in/site").status, 0);
    EXPECT_TRUE(fs::exists(folder / "in/site/scenes/gone.html"));
    fs::remove(folder / "in/gone.glib");
    ASSERT_EQ(gallery("-o in/site").status, 0);
    for (const char* each : {"scenes/gone.html", "pictures/gone.png", "films/gone.png"})
        EXPECT_FALSE(fs::exists(folder / "in/site" / each)) << each;
    EXPECT_TRUE(fs::exists(folder / "in/site/scenes/still-b.html"));
}

TEST_F(GalleryCommand, ReadsNothingOutsideOfTheFolder) {
    folder.write("secret.frag", "#version 330\nout vec4 c;\nvoid main() { c = vec4(1.); /* theSecret */ }\n");
    folder.write("in/still/b.glib", scene("../../secret.frag"));
    fs::create_symlink(folder / "secret.frag", folder / "in/moves/l.frag");
    folder.write("in/moves/a.glib", scene("l.frag"));
    folder.write("README.md", "| [a](moves/a.glib) | x | theSecret |\n");
    fs::create_symlink(folder / "README.md", folder / "in/README.md");
    const Finished run = gallery();
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(readFile(folder / "site/scenes/still-b.html"), "file-E12")) << run.err;
    EXPECT_FALSE(contains(shell(folder.path(), "cat site/*.html site/scenes/*.html").out, "theSecret"));
    EXPECT_FALSE(fs::exists(folder / "site/pictures/still-b.png"));
}

TEST_F(GalleryCommand, FindsTheLibraryAboveTheFolder) {
    folder.write("shaders/q2.vert", kVertexShader);
    folder.write(
        "in/still/b.glib",
        "WindowSize 40 30\nOrtho -1 1 -1 1\nVertex q2.vert\nFragment b.frag\nProgram P\nQuadXY 0 1\n");
    const Finished run = gallery();
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(readFile(folder / "site/scenes/still-b.html"), "q2.vert"));
}

TEST_F(GalleryCommand, HasTheChaptersOfTheFoldersTable) {
    folder.write(
        "in/README.md",
        "| [a](moves/a.glib) | moves | Book, chapters 2 and 10 |\n| [b](still/b.glib) | still | - |\n");
    ASSERT_EQ(gallery().status, 0);
    const std::string page = readFile(folder / "site/chapters.html");
    EXPECT_LT(page.find("Book, chapter 2"), page.find("Book, chapter 10"));
    EXPECT_FALSE(contains(page, "still-b.html"));
}

TEST_F(GalleryCommand, ASceneThatNeverEndsCostsItsOwnPicture) {
    folder.write("in/still/b.frag",
                 "#version 330\nuniform float uG; out vec4 c;\nvoid main() { float s = 0.;\n"
                 "for (int i = 0; i < 2000000000; ++i) s += sin(float(i) * uG); c = vec4(s); }\n");
    const Finished run = gallery("-o site --timeout 2");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.err, "still/b.glib: timed-out")) << run.err;
    EXPECT_TRUE(fs::exists(folder / "site/films/moves-a.png"));
    EXPECT_TRUE(contains(readFile(folder / "site/scenes/still-b.html"), "2000000000"));
}

TEST_F(GalleryCommand, IsTheSameInASandbox) {
    if (!system::missingForSandbox().empty()) GTEST_SKIP() << system::missingForSandbox();
    const Finished run = gallery("-o site --untrusted");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(site(), kWholeSite);
    const std::string confined = readFile(folder / "site/films/moves-a.png");
    ASSERT_EQ(gallery().status, 0);
    EXPECT_EQ(readFile(folder / "site/films/moves-a.png"), confined);
}

TEST_F(GalleryCommand, AStoppedRunLeavesNoPage) {
    ASSERT_EQ(gallery().status, 0);
    folder.write("in/still/b.frag",
                 "#version 330\nuniform float uG; out vec4 c;\nvoid main() { float s = 0.;\n"
                 "for (int i = 0; i < 2000000000; ++i) s += sin(float(i) * uG); c = vec4(s); }\n");
    const Finished run = shell(folder.path(), "timeout -s INT 3 '" GLIBRA_PROGRAM "' gallery in -o site");
    EXPECT_TRUE(contains(run.err, "stopped; no page was written")) << run.err;
    EXPECT_FALSE(fs::exists(folder / "site/index.html"));
    EXPECT_FALSE(contains(site(), "frame="));
}

TEST_F(GalleryCommand, TheClassIsGradedByAnExercise) {
    folder.write("solution.toml",
                 "solution = \"in/moves/a.glib\"\ntimes = [0, 1]\nsweep = [\"uG=[0.2, 0.9]\"]\n");
    const Finished run = glibra(folder.path(), "class in --reference solution.toml -o graded");
    EXPECT_EQ(run.status, 0) << run.err;
    const std::string grades = readFile(folder / "graded/grades.csv");
    for (const char* each : {"uG=0.2, time=0", "uG=0.9, time=1"})
        EXPECT_TRUE(contains(grades, each)) << grades;
}

TEST_F(GalleryCommand, AClassOfASuiteOrAnExerciseHasTheLibraryThatIsNamed) {
    folder.write("library/shaders/given.vert", kVertexShader);
    folder.write("in/moves/a.glib", scene("a.frag"));
    folder.write("all/ana/a.frag", kMovingFragment);
    std::string own = scene("a.frag");
    own.replace(own.find("q.vert"), 6, "given.vert");
    folder.write("all/ana/a.glib", own);
    folder.write("exercise.toml", "solution = \"in/moves/a.glib\"\n");
    folder.write("suite.toml", "[[shot]]\nscript = \"in/moves/a.glib\"\n");
    for (const char* each : {"exercise.toml", "suite.toml"}) {
        const std::string command = std::string("class all -o graded --reference ") + each;
        EXPECT_TRUE(contains(glibra(folder.path(), command).err, "1 failed")) << each;
        const Finished run = glibra(folder.path(), command + " --library library");
        EXPECT_TRUE(contains(run.err, "1 drawn")) << each << run.err;
    }
}

TEST_F(GalleryCommand, FilesOfGlibrasLibraryAreHintedAt) {
    folder.write("in/still/b.glib",
                 "WindowSize 40 30\nVertex modern/world.vert\nFragment b.frag\nProgram P\nSphere\n");
    for (const char* each : {"gallery in -o site", "class in --reference in/moves/a.glib -o graded"}) {
        const Finished run = glibra(folder.path(), each);
        EXPECT_TRUE(contains(run.err, "the library of glibra has 'modern/world.vert'; --library")) << run.err;
    }
}

}  // namespace
}  // namespace glibra::test
