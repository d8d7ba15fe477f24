// A run that does not begin, or does not reach its end, leaves no results of an earlier one that look like
// its own.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

class StaleResults : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .5\n");
        folder.write("s.toml", kGood);
        ASSERT_EQ(run("--update").status, 0);
        green();
    }
    Finished run(const std::string& arguments, const std::string& what = "s.toml") {
        return glibra(folder.path(), "test " + what + " --junit out/junit.xml --report page " + arguments);
    }
    /// A run that passes, with everything that it writes.
    void green() {
        folder.write("s.toml", kGood);
        const Finished end = run("");
        ASSERT_EQ(end.status, 0) << end.err;
        ASSERT_TRUE(contains(readFile(folder / "out/junit.xml"), "errors=\"0\""));
        ASSERT_TRUE(contains(readFile(folder / "page/index.html"), "None of 1 shots failed"));
        ASSERT_TRUE(contains(readFile(folder / "glibra-results/results.jsonl"), "{\"end\""));
    }
    void expectNothingGreen(const std::string& what) {
        EXPECT_TRUE(contains(readFile(folder / "out/junit.xml"), "has not reached its end")) << what;
        EXPECT_TRUE(contains(readFile(folder / "out/junit.xml"), "errors=\"1\"")) << what;
        EXPECT_TRUE(contains(readFile(folder / "page/index.html"), "has not reached its end")) << what;
        EXPECT_FALSE(contains(readFile(folder / "page/index.html"), "None of 1")) << what;
        const std::string results = readFile(folder / "glibra-results/results.jsonl");
        EXPECT_FALSE(contains(results, "{\"end\"")) << what;
        EXPECT_NE(glibra(folder.path(), "test --merge glibra-results --results merged").status, 0) << what;
    }

    static constexpr const char* kGood = "goldens = \"golden\"\n[[shot]]\nscript = \"a.glib\"\n";
    Folder folder;
};

TEST_F(StaleResults, AreMarkedWhateverRefusesTheRun) {
    const struct {
        const char* suite;
        const char* arguments;
    } refused[] = {
        {"this is no suite", ""},
        {"[[shot]]\nscript = \"missing.glib\"\n", ""},
        {"[[shot]]\nscript = \"a.glib\"\n[[shot]]\nscript = \"a.glib\"\n", "--resume"},
        {kGood, "--only nothing"},
        {kGood, "--shard 3/2"},
        {kGood, "--force"},
        {kGood, "--root ."},
        {kGood, "--update --untrusted"},
        {kGood, "--driver egl-device"},  // if there is one, the run is green and needs no mark
    };
    for (const auto& each : refused) {
        green();
        folder.write("s.toml", each.suite);
        const Finished end = run(each.arguments);
        if (end.status == 0) continue;
        EXPECT_GE(end.status, 2) << each.suite << each.arguments;
        expectNothingGreen(std::string(each.suite) + each.arguments);
    }
    green();
    EXPECT_EQ(run("", "no-such-suite.toml").status, 3);
    expectNothingGreen("a suite that is not there");
    green();
    EXPECT_EQ(run("", "").status, 2);
    expectNothingGreen("no suite");
}

/// The shots of a run that is refused stay for the one that is not.
TEST_F(StaleResults, CanStillBeResumed) {
    folder.write("s.toml", "this is no suite");
    ASSERT_EQ(run("--resume").status, 3);
    folder.write("s.toml", kGood);
    const Finished rest = run("--resume");
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_FALSE(contains(rest.err, "drawn again")) << rest.err;
    EXPECT_TRUE(contains(readFile(folder / "out/junit.xml"), "errors=\"0\""));
}

TEST_F(StaleResults, FilesOfOthersAreLeftAlone) {
    folder.write("out/junit.xml", "<?xml version=\"1.0\"?>\n<testsuites name=\"other\"/>\n");
    folder.write("page/index.html", "<title>My page</title>\n");
    folder.write("s.toml", "this is no suite");
    ASSERT_EQ(run("").status, 3);
    EXPECT_TRUE(contains(readFile(folder / "out/junit.xml"), "name=\"other\""));
    EXPECT_EQ(readFile(folder / "page/index.html"), "<title>My page</title>\n");
    // A scene or a suite that --junit names is refused as ever.
    folder.write("s.toml", kGood);
    EXPECT_EQ(glibra(folder.path(), "test s.toml --junit s.toml").status, 3);
    EXPECT_EQ(readFile(folder / "s.toml"), kGood);
}

/// On a full disk (here: files may not grow) nothing green stays either.
TEST_F(StaleResults, AreMarkedOrRemovedOnAFullDisk) {
    const Finished end = shell(folder.path(), "{ ulimit -f 0; '" GLIBRA_PROGRAM
                                              "' test s.toml --junit out/junit.xml --report page; }");
    EXPECT_NE(end.status, 0);
    for (const char* each : {"out/junit.xml", "page/index.html"})
        if (std::filesystem::exists(folder / each)) {
            EXPECT_TRUE(contains(readFile(folder / each), "has not reached its end")) << each;
        }
    EXPECT_FALSE(contains(readFile(folder / "glibra-results/results.jsonl"), "{\"end\""));
}

TEST_F(StaleResults, OfAMergeThatFailsAreMarkedToo) {
    ASSERT_EQ(
        glibra(folder.path(), "test --merge glibra-results --results merged --junit out/junit.xml").status,
        0);
    ASSERT_TRUE(contains(readFile(folder / "merged/results.jsonl"), "{\"end\""));
    EXPECT_NE(glibra(folder.path(), "test --merge nowhere --results merged --junit out/junit.xml").status, 0);
    EXPECT_TRUE(contains(readFile(folder / "out/junit.xml"), "has not reached its end"));
    EXPECT_FALSE(contains(readFile(folder / "merged/results.jsonl"), "{\"end\""));
    // A folder may be merged into itself.
    ASSERT_EQ(run("").status, 0);
    EXPECT_EQ(glibra(folder.path(), "test --merge glibra-results").status, 0);
}

}  // namespace
}  // namespace glibra::test
