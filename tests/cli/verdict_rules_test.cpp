// Ways by which a run could be green although something was not compared, as a user or a stranger would try
// them.

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

class VerdictRules : public testing::Test {
  protected:
    void SetUp() override {
        scene(".5");
        suite("");
    }
    void scene(const std::string& radius, const std::string& more = {}) {
        folder.write("a.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere " + radius + "\n" + more);
    }
    void suite(const std::string& more) {
        folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = \"a.glib\"\n" + more);
    }
    Finished run(const std::string& arguments = {}) {
        return glibra(folder.path(), "test s.toml " + arguments);
    }
    /// The words of the only line of accepted pixels: shot, variant, golden, pixels, and the driver as the
    /// rest.
    std::vector<std::string> acceptedLine() {
        const std::string list = readFile(folder / "golden/s.hashes");
        std::string line = list.substr(list.rfind('\n', list.size() - 2) + 1);
        std::vector<std::string> words;
        for (int i = 0; i < 4; ++i) {
            words.push_back(line.substr(0, line.find(' ')));
            line.erase(0, line.find(' ') + 1);
        }
        words.push_back(line);
        return words;
    }

    Folder folder;
};

TEST_F(VerdictRules, AForgedLineDecidesNothing) {
    ASSERT_EQ(run("--update").status, 0);
    const std::string golden = readFile(folder / "golden/a.png");
    const std::vector<std::string> good = acceptedLine();
    scene(".9");
    ASSERT_EQ(run("--update").status, 0);
    const std::vector<std::string> other = acceptedLine();
    ASSERT_NE(good[3], other[3]);
    folder.write("golden/a.png", golden);
    folder.write("golden/s.hashes", good[0] + " - " + good[2] + " " + other[3] + " " + good[4]);
    EXPECT_EQ(run().status, 1) << "whoever wrote the list";
    scene(".5");
    EXPECT_EQ(run().status, 0) << "the golden decides";
}

TEST_F(VerdictRules, ALostGoldenIsMissingAlthoughTheSceneChecksItself) {
    scene(".5", "Expect finite window\n");
    EXPECT_EQ(run().status, 0) << "a scene with checks needs no golden";
    ASSERT_EQ(run("--update").status, 0);
    ASSERT_EQ(run().status, 0);
    ASSERT_EQ(shell(folder.path(), "rm golden/a.png").status, 0);
    const Finished lost = run();
    EXPECT_EQ(lost.status, 1) << lost.out;
    EXPECT_TRUE(contains(lost.out, "golden/a.png")) << lost.out;
    EXPECT_TRUE(contains(lost.out, "golden/s.hashes")) << lost.out;
    // The ways out: --update, and what the message names.
    ASSERT_EQ(run("--update").status, 0);
    EXPECT_EQ(run().status, 0);
    ASSERT_EQ(shell(folder.path(), "rm golden/a.png").status, 0);
    suite("golden = false\n");
    EXPECT_EQ(run().status, 0);
}

TEST_F(VerdictRules, ANewSceneWithoutItsGoldenIsMissingAlthoughItChecksItself) {
    scene(".5", "Expect finite window\n");
    suite("[[shot]]\nscript = \"new*.glib\"\nname = \"of\"\n");
    folder.write("new1.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .3\nExpect finite window\n");
    EXPECT_EQ(run().status, 0) << "no shot has a golden";
    ASSERT_EQ(run("--only a --update").status, 0);
    const Finished missing = run();
    EXPECT_EQ(missing.status, 1) << missing.out;
    EXPECT_TRUE(contains(missing.out, "new1.png")) << missing.out;
    EXPECT_TRUE(contains(missing.out, "golden = false")) << missing.out;
    EXPECT_EQ(run("--resume").status, 1);
    ASSERT_EQ(run("--update").status, 0);
    EXPECT_EQ(run().status, 0);
    // A golden that no run looks at is left over.
    suite("[[shot]]\nscript = \"new*.glib\"\nname = \"of\"\ngolden = false\n");
    const Finished orphan = run();
    EXPECT_EQ(orphan.status, 0) << orphan.out;
    EXPECT_TRUE(contains(orphan.out + orphan.err, "new1.png")) << orphan.out << orphan.err;
}

TEST_F(VerdictRules, APictureThatNothingIsComparedWithFails) {
    suite("golden = false\n");
    const Finished alone = run();
    EXPECT_EQ(alone.status, 1) << alone.out;
    EXPECT_TRUE(contains(alone.out, "suite-E21")) << alone.out;
    EXPECT_EQ(run("--update").status, 1) << "there is nothing to update";
    scene(".5", "Expect finite window\n");
    EXPECT_EQ(run().status, 0);
    scene(".5");
    const std::string pair = "[[shot]]\nname = \"b\"\nscript = \"a.glib\"\ngolden = false\nmatch = \"a\"\n";
    suite("golden = false\n" + pair);
    EXPECT_EQ(run().status, 0) << "the other shot compares it";
    EXPECT_TRUE(contains(run("--only a").out, "2 passed")) << "which comes along";
}

TEST_F(VerdictRules, PartsOfDifferentRunsAreNotMerged) {
    const std::string second = "[[shot]]\nname = \"b\"\nscript = \"a.glib\"\n";
    suite(second);
    ASSERT_EQ(run("--update").status, 0);
    ASSERT_EQ(run("--shard 1/2 --results 1").status, 0);
    ASSERT_EQ(run("--shard 2/2 --results 2").status, 0);
    const auto merged = [&] {
        return glibra(folder.path(), "test --merge 1 2 --results all --junit all.xml");
    };
    ASSERT_EQ(merged().status, 0) << merged().err;
    const struct {
        const char* what;
        std::string suite, arguments;
    } changes[] = {
        {"a tolerance",
         "tolerance = { max = 254, fraction = 1, cluster = 999, line = 999, bias = 255 }\n" + second, ""},
        {"a shot", second + "[[shot]]\nname = \"c\"\nscript = \"a.glib\"\nmatch = \"a\"\ngolden = false\n",
         ""},
        {"an option", second, "--no-skip"},
        {"a selection", second, "--only a --only b --timeout 99"}};
    for (const auto& each : changes) {
        suite(each.suite);
        const Finished part = run("--shard 2/2 --results 2 " + each.arguments);
        ASSERT_EQ(part.status, 0) << each.what << part.out << part.err;
        const Finished end = merged();
        EXPECT_EQ(end.status, 3) << each.what;
        EXPECT_TRUE(contains(end.err, "[result-E06]")) << each.what << end.err;
        EXPECT_FALSE(contains(readFile(folder / "all/results.jsonl"), "{\"end\"")) << each.what;
    }
    suite(second);
    ASSERT_EQ(run("--shard 2/2 --results 2").status, 0);
    EXPECT_EQ(merged().status, 0);
}

TEST_F(VerdictRules, ResultsThatCameWithASuiteAreNotResumedWithUntrusted) {
    ASSERT_EQ(run("--update").status, 0);
    const Finished first = run("--untrusted");
    if (first.status == 4) GTEST_SKIP() << first.err;
    const Finished rest = run("--untrusted --resume");
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_TRUE(contains(rest.err, "all shots are drawn")) << rest.err;
    EXPECT_FALSE(contains(run("--untrusted --resume --results /tmp/glibra-elsewhere-results").err,
                          "all shots are drawn"));
    shell(folder.path(), "rm -r /tmp/glibra-elsewhere-results");
}

/// A picture of floats in the portable format, all of one value except the first.
std::string pfm(float value, float first) {
    std::string text = "PF\n16 16\n-1.0\n";
    for (int i = 0; i < 16 * 16 * 3; ++i) {
        const float each = i == 0 ? first : value;
        char bytes[4];
        std::memcpy(bytes, &each, 4);
        text.append(bytes, 4);
    }
    return text;
}

TEST_F(VerdictRules, PerceptualMeasuresDoNotPassFloatsThatTheyDoNotSee) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const struct {
        float value, first, otherValue, otherFirst;
        int status;
    } pairs[] = {{1, 1, 2, 2, 1},
                 {1, 1, 100, 100, 1},
                 {infinity, infinity, 3e38F, 3e38F, 1},
                 {.5F, .5F, .5F, nan, 1},
                 {.5F, .5F, .5F, infinity, 1},
                 {1, 1, 50, 50, 1},
                 {.5F, .5F, .5F, .5F, 0},
                 {7, 7, 7, 7, 0},
                 {.5F, .5F, .51F, .51F, 0}};
    for (const auto& each : pairs) {
        folder.write("a.pfm", pfm(each.value, each.first));
        folder.write("b.pfm", pfm(each.otherValue, each.otherFirst));
        for (const char* limits : {"--flip 0.2", "--structure 0.2", "--flip 0.2 --structure 0.2",
                                   "--flip 0.2 --structure 0.2 --fraction 0.5 --cluster 1000 --line 100"}) {
            const Finished end = glibra(folder.path(), std::string("compare a.pfm b.pfm ") + limits);
            EXPECT_EQ(end.status, each.status)
                << each.value << " " << each.otherValue << " " << each.otherFirst << " " << limits << "\n"
                << end.out << end.err;
        }
    }
}

}  // namespace
}  // namespace glibra::test
