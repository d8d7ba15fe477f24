// `glibra review --accept`, and the tolerance that a failure proposes, as a user has them.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

namespace glibra::test {
namespace {

constexpr const char* kSuite = "[[shot]]\nscript = \"*.glib\"\nsize = [64, 48]\n";

class FailedRun : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("s.toml", kSuite);
        for (const char* each : {"a", "b"}) scene(each, ".5");
        ASSERT_EQ(run("test s.toml --update").status, 0);
        scene("a", ".53");
        scene("b", ".51");
        failed = run("test s.toml");
        ASSERT_EQ(failed.status, 1) << failed.out;
    }
    void scene(const std::string& name, const std::string& radius) const {
        folder.write(name + ".glib", "WindowSize 64 48\nOrtho -1 1 -1 1\nSphere " + radius + "\n");
    }
    [[nodiscard]] Finished run(const std::string& arguments) const {
        return glibra(folder.path(), arguments);
    }

    Folder folder;
    Finished failed;
};

TEST_F(FailedRun, IsAcceptedByNames) {
    const Finished one = run("review --accept a");
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(one.out, "accepted: s/a\n1 accepted, 0 refused\n");
    const Finished then = run("test s.toml --results then");
    EXPECT_EQ(then.status, 1);
    EXPECT_TRUE(contains(then.out, "1 failed, 1 passed")) << then.out;
    EXPECT_EQ(run("review --accept 's/*'").status, 0);
    EXPECT_EQ(run("test s.toml").status, 0);
}

/// As a run that was killed leaves it: nobody may take it for one in which all is well.
TEST_F(FailedRun, IsNotWellIfItHasNotEnded) {
    const std::string whole = readFile(folder / "glibra-results/results.jsonl");
    folder.write("glibra-results/results.jsonl", whole.substr(0, whole.find('\n') + 1));
    const Finished cut = run("review");
    EXPECT_EQ(cut.status, 3);
    EXPECT_FALSE(contains(cut.out, "nothing has failed")) << cut.out;
    EXPECT_TRUE(contains(cut.err, "[result-E03]")) << cut.err;
}

TEST_F(FailedRun, SaysWhatIsNotAccepted) {
    const Finished none = run("review --accept c");
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(none.out, "no shot of these names needs a look\n");
    EXPECT_EQ(run("review --accept a --serve").status, 2);
    folder.write("s.toml", "goldens = \"../elsewhere\"\n" + std::string(kSuite));
    const Finished outside = run("review --accept a");
    EXPECT_EQ(outside.status, 1);
    EXPECT_TRUE(contains(outside.out, "refused: s/a: its golden is outside of the suite's folder"))
        << outside.out;
}

/// The proposed line is pasted below the [[shot]]: then it passes, and one pixel less does not.
TEST_F(FailedRun, PassesWithTheLineThatItProposes) {
    const std::string kBefore = "would pass      ";
    const std::size_t at = failed.out.find(kBefore, failed.out.rfind("failed s/b"));
    ASSERT_NE(at, std::string::npos) << failed.out;
    const std::size_t from = at + kBefore.size();
    const std::string line = failed.out.substr(from, failed.out.find('\n', from) - from);
    const auto with = [&](const std::string& tolerance) {
        folder.write("s.toml", kSuite + tolerance + "\n");
        return run("test s.toml --only b").status;
    };
    EXPECT_EQ(with(line), 0) << line;
    const std::size_t fraction = line.find("fraction = ");
    ASSERT_NE(fraction, std::string::npos) << line;
    const double pixel = 1. / (64 * 48);
    const double less = std::stod(line.substr(fraction + 11)) - pixel;
    EXPECT_EQ(with("tolerance = { fraction = " + std::to_string(less) + ", cluster = 64, line = 64 }"), 1)
        << line;
}

}  // namespace
}  // namespace glibra::test
