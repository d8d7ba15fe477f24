// `glibra test` and `glibra render --suite`, run as a user runs them.

#include <gtest/gtest.h>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// A suite of three shots of one scene, lit by a uniform.
class TestCommand : public testing::Test {
  protected:
    void SetUp() override {
        folder.write(
            "a.vert",
            "#version 330 core\nout vec3 vN;\nvoid main() { vN = uNormalMatrix * aNormal; gl_Position = "
            "uModelViewProjectionMatrix * aVertex; }\n");
        light("1.");
        folder.write(
            "a.glib",
            "LookAt 0 0 4 0 0 0 0 1 0\nVertex a.vert\nFragment a.frag\nProgram P uKd <0. 1. 2.>\nSphere 1 40 "
            "40\n");
        folder.write(
            "s.toml",
            "goldens = \"golden\"\n[defaults]\nsize = [64, 48]\n[[shot]]\nscript = \"a.glib\"\nsweep = { uKd "
            "= [0.4, 0.7, 1] }\n");
    }
    void light(const std::string& factor) {
        folder.write("a.frag",
                     "#version 330 core\nin vec3 vN;\nuniform float uKd;\nout vec4 f;\nvoid main() { f = "
                     "vec4(vec3(.1 + .8 * " +
                         factor + " * uKd * abs(normalize(vN).z)), 1.); }\n");
    }
    Finished run(const std::string& arguments, const std::string& environment = {}) {
        return glibra(folder.path(), "test " + arguments, environment);
    }
    void accept() { ASSERT_EQ(run("s.toml --update").status, 0); }
    bool exists(const std::string& name) { return fs::exists(folder / name); }

    Folder folder;
};

TEST_F(TestCommand, FailsWithoutGoldensPassesWithThem) {
    const Finished missing = run("s.toml");
    EXPECT_EQ(missing.status, 1);
    EXPECT_TRUE(contains(missing.out, "3 drawn, none has a golden yet")) << missing.out;
    EXPECT_FALSE(exists("golden"));
    const Finished update = run("s.toml --update");
    EXPECT_EQ(update.status, 0) << update.out << update.err;
    EXPECT_TRUE(exists("golden/a@uKd=0.4.png"));
    const Finished passed = run("s.toml");
    EXPECT_EQ(passed.status, 0) << passed.out;
    EXPECT_TRUE(contains(passed.out, "3 passed")) << passed.out;
}

TEST_F(TestCommand, AChangedShaderFailsAndUpdateAcceptsIt) {
    accept();
    light("1.1");
    const Finished failed = run("s.toml");
    EXPECT_EQ(failed.status, 1);
    EXPECT_TRUE(contains(failed.out, "3 failed")) << failed.out;
    EXPECT_TRUE(exists("glibra-results/s/a@uKd=0.7.got.png"));
    EXPECT_TRUE(exists("glibra-results/s/a@uKd=0.7.difference.png"));
    accept();
    EXPECT_EQ(run("s.toml").status, 0);
    EXPECT_FALSE(exists("glibra-results/s/a@uKd=0.7.got.png")) << "an earlier run's picture";
}

TEST_F(TestCommand, AnInvisibleChangePassesAndIsReported) {
    accept();
    light("1.002");
    const Finished run = this->run("s.toml");
    EXPECT_EQ(run.status, 0) << run.out;
    EXPECT_TRUE(contains(run.err, "changed: s/a@uKd=1")) << run.err;
}

TEST_F(TestCommand, ABrokenSceneIsStatusThreeAndTheOthersAreDrawn) {
    accept();
    folder.write("b.glib", "Spere\n");
    folder.write("t.toml", readFile(folder / "s.toml") + "[[shot]]\nscript = \"b.glib\"\n");
    const Finished run = this->run("t.toml");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.out, "b.glib:1:1: error:")) << run.out;
    EXPECT_TRUE(contains(run.out, "3 passed")) << run.out;
}

TEST_F(TestCommand, AMisspeltUniformIsAMistakeOfTheSuite) {
    accept();
    folder.write("t.toml", readFile(folder / "s.toml") +
                               "[[shot]]\nscript = \"a.glib\"\nname = \"b\"\nsweep = { uKdd = [0.4, 1] }\n"
                               "[[shot]]\nscript = [\"a.glib\"]\nname = \"c\"\nset = { uKd = 0.4 }\n");
    const Finished run = this->run("t.toml --update");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.out,
                         "t.toml:10:11: error: no program of the scene has a uniform 'uKdd'; did you mean "
                         "'uKd'? [suite-E19]"))
        << run.out;
    EXPECT_TRUE(contains(run.out, "2 failed, 1 updated, 3 passed")) << run.out;
    EXPECT_FALSE(exists("golden/b@uKdd=1.png"));
}

TEST_F(TestCommand, AUniformOfTheDefaultsNeedNotBeInEveryScene) {
    folder.write("t.toml",
                 "goldens = \"golden\"\n[defaults]\nset = { uOther = 1 }\nsize = [64, 48]\n[[shot]]\nscript "
                 "= \"a.glib\"\n");
    ASSERT_EQ(run("t.toml --update").status, 0);
    const Finished run = this->run("t.toml");
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(contains(
        run.out, "warning: no program of the scene has a uniform 'uOther' [glib-W23] in 1 shot, as t/a"))
        << run.out;
}

TEST_F(TestCommand, WrongUsageIsStatusTwo) {
    for (const char* each : {"", "s.toml --shard 4/3", "s.toml --only nothing", "s.toml --force",
                             "s.toml --merge r", "s.toml --jobs 0", "s.toml --driver gl"}) {
        const Finished run = this->run(each);
        EXPECT_EQ(run.status, 2) << each << "\n" << run.err;
        EXPECT_FALSE(run.err.empty()) << each;
    }
    EXPECT_EQ(run("none.toml").status, 3);
}

TEST_F(TestCommand, ReportAndJunitAreWritten) {
    accept();
    ASSERT_EQ(run("s.toml --report web/report --junit ci/j.xml --results r").status, 0);
    EXPECT_TRUE(exists("web/report/index.html"));
    EXPECT_TRUE(contains(readFile(folder / "ci/j.xml"), "<testcase"));
    EXPECT_TRUE(exists("r/results.jsonl"));
}

TEST_F(TestCommand, ShardsMergeToTheWholeRun) {
    accept();
    for (const char* each : {"1", "2"})
        EXPECT_EQ(run(std::string("s.toml --shard ") + each + "/2 --results r" + each).status, 0);
    const Finished merged = run("--merge r1 r2 --results all --junit j.xml");
    EXPECT_EQ(merged.status, 0) << merged.err;
    EXPECT_TRUE(contains(merged.out, "3 passed")) << merged.out;
}

TEST_F(TestCommand, AHangingShotCostsOnlyItself) {
    // Drivers end a loop after some ten thousand rounds, so the picture has many pixels.
    folder.write("hang.frag",
                 "#version 330 core\nuniform float uKd;\nout vec4 f;\nvoid main() { float x = uKd; "
                 "while (x < 9.) x = sin(x + uKd); f = vec4(x); }\n");
    folder.write("h.glib", "Vertex a.vert\nFragment hang.frag\nProgram P uKd <0. 1. 2.>\nSphere 1 8 8\n");
    folder.write("t.toml",
                 readFile(folder / "s.toml") + "[[shot]]\nscript = \"h.glib\"\nsize = [4000, 4000]\n");
    const Finished run = this->run("t.toml --timeout 2 --update --jobs 1");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.out, "1 timed-out, 3 updated")) << run.out;
}

TEST_F(TestCommand, AnyNumberOfJobsGivesTheSameResults) {
    accept();
    light("1.1");
    std::string first;
    for (const char* each : {"1", "2", "5"}) {
        const std::string results = std::string("r") + each;
        ASSERT_EQ(run("s.toml --jobs " + std::string(each) + " --results " + results).status, 1);
        const std::string got = readFile(folder / (results + "/s/a@uKd=0.7.got.png"));
        EXPECT_GT(got.size(), 100U);
        if (first.empty()) first = got;
        EXPECT_EQ(got, first);
    }
}

TEST_F(TestCommand, OsmesaPassesGoldensOfEgl) {
    ASSERT_EQ(run("s.toml --update --driver egl").status, 0);
    EXPECT_EQ(run("s.toml", "LP_NATIVE_VECTOR_WIDTH=128").status, 0);
    if (!hasOsmesa()) GTEST_SKIP() << kNoOsmesa;
    EXPECT_EQ(run("s.toml --driver osmesa").status, 0);
}

TEST_F(TestCommand, NoDriverIsStatusFour) {
    const Finished run = this->run("s.toml --driver egl", "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null");
    EXPECT_EQ(run.status, 4) << run.err;
    EXPECT_TRUE(contains(run.err, "gpu-E01")) << run.err;
}

TEST_F(TestCommand, PicturesOfSuitesAreThoseOfScenes) {
    const Finished all = glibra(folder.path(), "render --suite s.toml -o out");
    ASSERT_EQ(all.status, 0) << all.err;
    EXPECT_TRUE(contains(all.err, "3 of 3 shots rendered")) << all.err;
    ASSERT_EQ(glibra(folder.path(), "render a.glib --size 64x48 --set uKd=0.7 -o one.png").status, 0);
    EXPECT_EQ(readFile(folder / "out/a@uKd=0.7.png"), readFile(folder / "one.png"));

    fs::remove(folder / "out/a@uKd=1.png");
    const Finished rest = glibra(folder.path(), "render --suite s.toml -o out --resume");
    EXPECT_TRUE(contains(rest.err, "1 of 1 shots rendered, 2 exist already")) << rest.err;
    EXPECT_TRUE(exists("out/a@uKd=1.png"));
    EXPECT_EQ(glibra(folder.path(), "render --suite s.toml --size 8x8").status, 2);
    EXPECT_EQ(glibra(folder.path(), "render").status, 2);
}

TEST_F(TestCommand, AMergeShowsNoFileThatSomebodyElseNames) {
    folder.write("outside/secret.txt", "TOP-SECRET\n");
    folder.write(
        "parts/1/results.jsonl",
        R"({"run":{"planned":[{"suite":"s","shots":["a"]}]}})"
        "\n"
        R"({"suite":"s","shot":"a","verdict":"failed","script":")" +
            (folder / "outside/secret.txt").string() +
            R"(","got":"link.png","expected":".git/hooks/post-checkout",)"
            R"("diagnostics":[{"severity":"error","id":"glib-E01","text":"x","place":{"file":"/etc/passwd","line":1,"column":1}}]})"
            "\n"
            R"({"end":{"shots":1}})"
            "\n");
    folder.write("parts/1/.git/hooks/post-checkout", "#!/bin/sh\n");
    fs::create_symlink(folder / "outside/secret.txt", folder / "parts/1/link.png");
    const Finished merged = run("--merge parts/1 --results all --report report");
    EXPECT_EQ(merged.status, 3) << merged.err;
    EXPECT_TRUE(contains(merged.err, "links are not followed")) << merged.err;
    EXPECT_TRUE(contains(merged.err, "is not a picture")) << merged.err;
    for (const char* each : {"all", "report"})
        for (const auto& file : fs::recursive_directory_iterator(folder / each)) {
            if (!file.is_regular_file()) continue;
            EXPECT_FALSE(contains(readFile(file.path()), "TOP-SECRET")) << file.path();
            EXPECT_FALSE(contains(readFile(file.path()), "root:x:0")) << file.path();
            EXPECT_NE(file.path().filename(), "post-checkout");
        }
    ASSERT_EQ(run("--merge parts/1 --results all --report report --root outside").status, 3);
    EXPECT_TRUE(contains(readFile(folder / "report/index.html"), "TOP-SECRET")) << "the user asked for it";
    EXPECT_EQ(run("s.toml --root outside").status, 2);
}

TEST_F(TestCommand, AResultWithATimeThatNoRunTakesIsAnError) {
    folder.write("parts/1/results.jsonl", "{\"run\":{\"seconds\":1e308}}\n");
    const Finished merged = run("--merge parts/1 --results all");
    EXPECT_EQ(merged.status, 3);
    EXPECT_TRUE(contains(merged.err, "'seconds': expected a number between 0 and 1000000000")) << merged.err;
    EXPECT_TRUE(contains(merged.err, "result-E01")) << merged.err;
}

TEST_F(TestCommand, UpdateOutsideOfTheFolderOfTheSuiteNeedsAFlag) {
    folder.write("tests/s.toml", "goldens = \"../gold\"\n[[shot]]\nscript = \"../a.glib\"\n");
    const Finished refused = run("tests/s.toml --update");
    EXPECT_EQ(refused.status, 2);
    EXPECT_TRUE(contains(refused.err, "suite-E20") && contains(refused.err, "--allow-outside"))
        << refused.err;
    EXPECT_FALSE(exists("gold"));
    EXPECT_EQ(run("tests/s.toml --update --goldens given").status, 0);
    EXPECT_TRUE(exists("given/s/a.png"));
    EXPECT_EQ(run("tests/s.toml --update --allow-outside").status, 0);
    EXPECT_EQ(run("tests/s.toml").status, 0) << "reading needs no flag";
}

TEST_F(TestCommand, UpdateDoesNotWriteThroughALink) {
    accept();
    folder.write("mine.png", "mine");
    fs::remove(folder / "golden/a@uKd=0.4.png");
    fs::create_symlink(folder / "mine.png", folder / "golden/a@uKd=0.4.png");
    light("1.1");
    const Finished update = run("s.toml --update --force --replace-unreadable --allow-outside");
    EXPECT_TRUE(contains(update.out, "a@uKd=0.4.png': it is a symbolic link")) << update.out;
    EXPECT_NE(update.status, 0);
    EXPECT_EQ(readFile(folder / "mine.png"), "mine");
}

TEST_F(TestCommand, APatternForTheWholeDiskIsAnErrorWithTheLimit) {
    fs::path deep = folder.path();
    for (int i = 0; i < 70; ++i) deep /= "d";
    fs::create_directories(deep);
    folder.write("t.toml", "[[shot]]\nscript = \"" + folder.path().string() + "/**/*.glib\"\n");
    const Finished finished = run("t.toml");
    EXPECT_EQ(finished.status, 3);
    EXPECT_TRUE(contains(finished.err, "200,000 files and 64 folders") && contains(finished.err, "suite-E11"))
        << finished.err;
    EXPECT_FALSE(contains(finished.err, "suite-E09")) << "one message is enough";
}

TEST_F(TestCommand, AFolderOfScenesIsASuite) {
    fs::create_directories(folder / "scenes");
    for (const char* each : {"a.glib", "a.vert", "a.frag"})
        fs::rename(folder / each, folder / (std::string("scenes/") + each));
    EXPECT_EQ(run("scenes --update").status, 0);
    EXPECT_EQ(run("scenes").status, 0);
}

TEST_F(TestCommand, AFolderWithAnotherScenesVariantIsRefused) {
    fs::create_directories(folder / "scenes");
    folder.write("scenes/a.glib", "Sphere 1\n");
    folder.write("scenes/a.llvmpipe.glib", "Sphere 1\n");
    const Finished refused = run("scenes --update");
    EXPECT_EQ(refused.status, 3);
    EXPECT_TRUE(contains(refused.err, "would be a variant of that of")) << refused.err;
    fs::rename(folder / "scenes/a.llvmpipe.glib", folder / "scenes/a.v2.glib");
    EXPECT_EQ(run("scenes --update").status, 0);
}

TEST_F(TestCommand, UpdateOfOneShotLeavesTheOnesItIsComparedWithAlone) {
    folder.write("s.toml",
                 "goldens = \"golden\"\n[defaults]\nsize = [64, 48]\n[[shot]]\nname = "
                 "\"left\"\nscript = \"a.glib\"\nset = { uKd = 0.4 }\n[[shot]]\nname = \"right\"\nscript = "
                 "\"a.glib\"\nset = { uKd = 1 }\ndiffer = "
                 "\"left\"\n");
    accept();
    const std::string left = readFile(folder / "golden/left.png");
    const std::string right = readFile(folder / "golden/right.png");
    light(".5");
    EXPECT_EQ(run("s.toml --only right --update").status, 0);
    EXPECT_TRUE(readFile(folder / "golden/left.png") == left);
    EXPECT_FALSE(readFile(folder / "golden/right.png") == right);
    EXPECT_EQ(run("s.toml --only right").status, 1) << "without --update the other one is judged too";
}

/// The second suite has never been updated, so that nothing in the folder names its pictures.
TEST(OrphanGoldens, OfTwoSuitesInOneFolderOnlyThoseThatWereListedAreRemoved) {
    const Folder folder;
    const std::string scene = "WindowSize 16 16\nBackground 0 0 .5\n";
    for (const char* each : {"a.glib", "b.glib", "c.glib"}) folder.write(each, scene);
    const std::string head = "goldens = \"golden\"\n[[shot]]\nscript = ";
    folder.write("one.toml", head + "[\"a.glib\", \"c.glib\"]\n");
    folder.write("two.toml", head + "\"b.glib\"\n");
    ASSERT_EQ(glibra(folder.path(), "test one.toml --update --force").status, 0);
    fs::copy_file(folder / "golden/a.png", folder / "golden/b.png");
    folder.write("one.toml", head + "\"a.glib\"\n");
    const Finished listed = glibra(folder.path(), "test one.toml");
    EXPECT_NE(listed.err.find("1 golden of no shot of 'one' (--prune removes them): golden/c.png"),
              std::string::npos)
        << listed.err;
    EXPECT_EQ(glibra(folder.path(), "test one.toml --prune").status, 0);
    EXPECT_FALSE(fs::exists(folder / "golden/c.png"));
    for (const char* each : {"golden/a.png", "golden/b.png"}) EXPECT_TRUE(fs::exists(folder / each)) << each;
}

TEST(OrphanGoldens, AreListedAndPruned) {
    const Folder folder;
    folder.write("all/a.glib", "Sphere\n");
    folder.write("all/b.glib", "Cube\n");
    ASSERT_EQ(glibra(folder.path(), "test all --update").status, 0);
    ASSERT_TRUE(std::filesystem::exists(folder / "all/golden/b.png"));
    std::filesystem::remove(folder / "all/b.glib");
    const Finished listed = glibra(folder.path(), "test all");
    EXPECT_EQ(listed.status, 0);
    EXPECT_NE(listed.err.find("1 golden of no shot of 'all' (--prune removes them): all/golden/b.png"),
              std::string::npos)
        << listed.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "all/golden/b.png"));
    const Finished partial = glibra(folder.path(), "test all --only a --prune");
    EXPECT_EQ(partial.status, 0) << partial.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "all/golden/b.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "all/golden/a.png"));
    EXPECT_EQ(glibra(folder.path(), "test all").err.find("golden of no shot"), std::string::npos);
    EXPECT_EQ(glibra(folder.path(), "test all --prune --untrusted").status, 2);
}

TEST(ResultPaths, OpenFromTheCurrentFolder) {
    const Folder folder;
    folder.write("all/a.glib", "Sphere\n");
    ASSERT_EQ(glibra(folder.path(), "test all --update").status, 0);
    folder.write("all/a.glib", "Cube\n");
    const Finished run = glibra(folder.path(), "test all --results some/results");
    EXPECT_EQ(run.status, 1);
    for (const char* title : {"    expected        ", "    got             ", "    difference      "}) {
        const std::size_t at = run.out.find(title);
        ASSERT_NE(at, std::string::npos) << title << run.out;
        const std::size_t begin = at + std::string_view(title).size();
        const std::string path = run.out.substr(begin, run.out.find('\n', begin) - begin);
        EXPECT_TRUE(std::filesystem::is_regular_file(folder / path)) << path;
    }
}

}  // namespace
}  // namespace glibra::test
