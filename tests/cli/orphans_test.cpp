// Goldens of scenes that were deleted or renamed: who hears of them, and what becomes of them.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

class DeletedScene : public testing::Test {
  protected:
    DeletedScene() {
        for (const char* each : {"a", "b", "c"}) scene(each, each[0] - 'a' + 1);
        folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = \"*.glib\"\n");
        EXPECT_EQ(run("--update").status, 0);
    }
    void scene(const std::string& name, int size) {
        folder.write(name + ".glib",
                     "WindowSize 16 16\nOrtho -4 4 -4 4\nSphere " + std::to_string(size) + "\n");
    }
    Finished run(const std::string& arguments) { return glibra(folder.path(), "test s.toml " + arguments); }
    std::string read(const std::string& name) { return readFile(folder / name); }
    void remove(const std::string& name) { fs::remove(folder / name); }

    Folder folder;
};

TEST_F(DeletedScene, IsNamedWhereverACiServerLooks) {
    remove("b.glib");
    const std::string files = " --summary s.md --report report --junit j.xml";
    EXPECT_EQ(run("--results one" + files).status, 0) << "it is no failure unless somebody says so";
    for (const char* each : {"s.md", "report/index.html", "j.xml"})
        EXPECT_TRUE(contains(read(each), "golden/b.png")) << each;
    EXPECT_FALSE(contains(read("j.xml"), "<failure"));
    const Finished strict = run("--strict-orphans --results one" + files);
    EXPECT_EQ(strict.status, 1);
    EXPECT_TRUE(contains(read("j.xml"), "<failure message=\"1 golden of no shot of &#39;s&#39;"))
        << read("j.xml");
    EXPECT_TRUE(contains(read("j.xml"), "failures=\"1\""));
    // The parts of a run say it, too, and their merge.
    for (const char* each : {"1", "2"})
        EXPECT_EQ(run(std::string("--shard ") + each + "/2 --results parts/" + each).status, 0);
    const std::string merge = "test --merge parts/1 parts/2 --results merged";
    const Finished merged = glibra(folder.path(), merge + files);
    EXPECT_EQ(merged.status, 0) << merged.err;
    EXPECT_TRUE(contains(merged.err, "1 golden of no shot of 's' (--prune removes them): golden/b.png"))
        << merged.err;
    for (const char* each : {"s.md", "report/index.html", "j.xml"})
        EXPECT_TRUE(contains(read(each), "golden/b.png")) << each;
    EXPECT_EQ(glibra(folder.path(), merge + " --strict-orphans").status, 1);
    EXPECT_EQ(glibra(folder.path(), "test --merge merged --results again --strict-orphans").status, 1);
    EXPECT_EQ(run("--prune --strict-orphans").status, 0) << "none is left";
}

TEST_F(DeletedScene, IsRecognizedUnderItsNewName) {
    const std::string golden = read("golden/b.png");
    remove("b.glib");
    scene("ball", 2);
    const Finished listed = run("");
    EXPECT_EQ(listed.status, 1);
    EXPECT_TRUE(contains(listed.out, "equals 'golden/b.png'")) << listed.out;
    EXPECT_TRUE(contains(listed.out, "glibra test s.toml --only ball --rename")) << listed.out;
    EXPECT_EQ(run("--rename --untrusted").status, 2);
    const Finished renamed = run("--rename");
    EXPECT_EQ(renamed.status, 0) << renamed.out << renamed.err;
    EXPECT_TRUE(contains(renamed.out, "was renamed")) << renamed.out;
    EXPECT_TRUE(read("golden/ball.png") == golden);
    EXPECT_FALSE(fs::exists(folder / "golden/b.png"));
    EXPECT_TRUE(contains(read("golden/s.hashes"), "\nball - "));
    EXPECT_FALSE(contains(read("golden/s.hashes"), "\nb - "));
    EXPECT_EQ(run("--strict-orphans").status, 0);
}

TEST_F(DeletedScene, IsRecognizedUnderItsNewNameThoughItChanged) {
    const auto round = [&](const std::string& name, const std::string& radius) {
        folder.write(name + ".glib", "WindowSize 16 16\nOrtho -4 4 -4 4\nSphere " + radius + "\n");
    };
    round("circles", "2.5");
    ASSERT_EQ(run("--update").status, 0);
    const std::string golden = read("golden/circles.png");
    remove("circles.glib");
    round("rings", "2.2");
    const Finished listed = run("");
    EXPECT_EQ(listed.status, 1);
    EXPECT_TRUE(contains(listed.out, "'golden/circles.png' belongs to no shot and may be that of this one"))
        << listed.out;
    EXPECT_TRUE(contains(listed.out, "glibra test s.toml --only rings --rename")) << listed.out;
    const Finished renamed = run("--rename");
    EXPECT_EQ(renamed.status, 1) << "nothing is accepted: " << renamed.out;
    EXPECT_TRUE(
        contains(renamed.out, "the golden 'golden/circles.png' was renamed; the picture is another one"))
        << renamed.out;
    EXPECT_TRUE(read("golden/rings.png") == golden);
    EXPECT_FALSE(fs::exists(folder / "golden/circles.png"));
    EXPECT_EQ(run("--strict-orphans").status, 1) << "it differs";
    round("rings", "2.5");
    EXPECT_EQ(run("--strict-orphans").status, 0);
}

/// A shot with the picture of a golden has it, and none that is merely like it.
TEST_F(DeletedScene, GoesToTheShotWithItsPictureFirst) {
    const std::string golden = read("golden/b.png");
    remove("b.glib");
    scene("a-first", 3);
    scene("z-last", 2);
    EXPECT_EQ(run("--rename").status, 1);
    EXPECT_TRUE(read("golden/z-last.png") == golden);
    EXPECT_FALSE(fs::exists(folder / "golden/a-first.png"));
}

/// A fault made in the same change is not accepted in passing.
TEST_F(DeletedScene, UnderANewNameAndWithAnotherPictureIsNotAcceptedByPruning) {
    remove("b.glib");
    scene("ball", 1);
    scene("a", 3);
    const Finished refused = run("--update --prune");
    EXPECT_EQ(refused.status, 1);
    EXPECT_FALSE(fs::exists(folder / "golden/ball.png"));
    EXPECT_TRUE(fs::exists(folder / "golden/b.png")) << "nothing is removed where something was refused";
    EXPECT_TRUE(contains(refused.err, "--prune removes nothing")) << refused.err;
    scene("ball", 2);
    EXPECT_EQ(run("--update --prune").status, 0) << "the same picture may take the place";
    EXPECT_TRUE(fs::exists(folder / "golden/ball.png"));
    EXPECT_FALSE(fs::exists(folder / "golden/b.png"));
}

TEST_F(DeletedScene, UpdateOfWhatIsMissingAcceptsNoRegression) {
    const std::string golden = read("golden/a.png");
    scene("a", 3);
    scene("new", 4);
    const Finished made = run("--update=missing");
    EXPECT_EQ(made.status, 1) << made.out;
    EXPECT_TRUE(read("golden/a.png") == golden);
    EXPECT_TRUE(fs::exists(folder / "golden/new.png"));
    const Finished wrong = run("--update=none");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_TRUE(contains(wrong.err, "error: --update: expected all or missing, found 'none'")) << wrong.err;
    const Finished empty = run("--update=");  // --update=$MODE, where nobody has set MODE
    EXPECT_EQ(empty.status, 2);
    EXPECT_TRUE(contains(empty.err, "error: --update= has no value")) << empty.err;
    EXPECT_TRUE(read("golden/a.png") == golden);
    EXPECT_EQ(run("--update=all").status, 0);
    EXPECT_FALSE(read("golden/a.png") == golden);
}

/// A verdict that somebody has edited in the results does not hold.
TEST_F(DeletedScene, ResumedVerdictsAreThoseOfTheRun) {
    scene("a", 3);
    ASSERT_EQ(run("").status, 1);
    std::string text = read("glibra-results/results.jsonl");
    const std::size_t at = text.find("\"verdict\":\"failed\"");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 18, "\"verdict\":\"passed\"");
    folder.write("glibra-results/results.jsonl", text);
    const Finished resumed = run("--resume");
    EXPECT_EQ(resumed.status, 1) << resumed.out;
    EXPECT_TRUE(contains(resumed.err, "1 shot of the earlier run is drawn again")) << resumed.err;
}

/// Whoever empties the plan of a part does not make the merge green.
TEST_F(DeletedScene, AMergeKnowsHowManyShotsItNeeds) {
    ASSERT_EQ(run("").status, 0);
    const std::string whole = read("glibra-results/results.jsonl");
    const std::string head = whole.substr(0, whole.find('\n'));
    const std::size_t plan = head.find("\"shots\":[");
    ASSERT_NE(plan, std::string::npos);
    const std::string emptied = head.substr(0, plan) + "\"shots\":[]" + head.substr(head.find(']', plan) + 1);
    folder.write("glibra-results/results.jsonl", emptied + "\n{\"end\":{\"shots\":0}}\n");
    const Finished merged = glibra(folder.path(), "test --merge glibra-results --results merged");
    EXPECT_EQ(merged.status, 3) << merged.out;
    EXPECT_TRUE(contains(merged.err, "result-E03")) << merged.err;
}

}  // namespace
}  // namespace glibra::test
