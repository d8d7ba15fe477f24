// Shots that are right in some drawings only, shots in quarantine, reports without a driver, lists of shots.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

class NoisySuite : public testing::Test {
  protected:
    void SetUp() override {
        scene(".5");
        suite("");
    }
    void scene(const std::string& radius) {
        folder.write("a.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere " + radius + "\n");
    }
    void suite(const std::string& more) {
        folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = \"a.glib\"\n" + more);
    }
    Finished run(const std::string& arguments = {}, const std::string& environment = {}) {
        return glibra(folder.path(), "test s.toml " + arguments, environment);
    }

    Folder folder;
};

TEST_F(NoisySuite, AShotInQuarantineFailsInTheReportOnly) {
    ASSERT_EQ(run("--update").status, 0);
    scene(".9");
    ASSERT_EQ(run().status, 1);
    suite("quarantine = \"2999-12-31\"\n");
    const Finished quarantined = run("--junit j.xml");
    EXPECT_EQ(quarantined.status, 0) << quarantined.out << quarantined.err;
    EXPECT_TRUE(contains(quarantined.out, "failed, in quarantine until 2999-12-31: ")) << quarantined.out;
    EXPECT_TRUE(contains(quarantined.out, "1 quarantined")) << quarantined.out;
    EXPECT_TRUE(contains(readFile(folder / "j.xml"), "<skipped message=\"failed, in quarantine"));
    suite("quarantine = \"2020-01-31\"\n");
    const Finished over = run();
    EXPECT_EQ(over.status, 1) << over.out;
    EXPECT_TRUE(contains(over.out + over.err, "suite-W02")) << over.out << over.err;
    scene(".5");
    const Finished healed = run();
    EXPECT_EQ(healed.status, 0);
    EXPECT_TRUE(contains(healed.out + healed.err, "suite-W02")) << healed.out << healed.err;
}

TEST_F(NoisySuite, AQuarantineThatEndsIsNoticedByResume) {
    ASSERT_EQ(run("--update").status, 0);
    scene(".9");
    suite("quarantine = \"2999-12-31\"\n");
    ASSERT_EQ(run().status, 0);
    suite("quarantine = \"2020-01-31\"\n");
    EXPECT_EQ(run("--resume").status, 1);
}

TEST_F(NoisySuite, AShotThatIsRightInOneOfItsDrawingsIsFlaky) {
    ASSERT_EQ(run("--update").status, 0);
    suite("retries = 20\n");
    // Somebody replaces the scene all the time, so that a drawing has either of two pictures.
    const Finished runs =
        shell(folder.path(),
              "(sed s/.5/.9/ a.glib > other; cp a.glib one\n"
              "(while [ -e one ]; do cp one x; mv x a.glib; cp other y; mv y a.glib; done) 2>/dev/null &\n"
              "for i in 1 2 3 4 5 6 7 8 9 10 11 12; do '" GLIBRA_PROGRAM
              "' test s.toml --results r > out 2>&1; s=$?; cat out;"
              " ! grep -q '^flaky' out || echo flaky: status $s;"
              " '" GLIBRA_PROGRAM
              "' test s.toml --results strict --strict-flaky > out2 2>&1; s=$?;"
              " ! grep -q '^unstable' out2 || echo strict $s;"
              " ! { grep -q '^flaky' out && grep -q '^unstable' out2; } || break; done; rm one; wait)");
    EXPECT_TRUE(contains(runs.out, "flaky")) << runs.out << runs.err;
    EXPECT_TRUE(contains(runs.out, "is right; before: ")) << runs.out;
    // A busy machine may draw the wrong picture twenty times in a row; that run has no flaky shot.
    EXPECT_TRUE(contains(runs.out, "flaky: status 0")) << runs.out;
    EXPECT_FALSE(contains(runs.out, "flaky: status 1")) << runs.out;
    EXPECT_TRUE(contains(runs.out, "strict 1")) << runs.out;
}

TEST_F(NoisySuite, AShotThatIsNeverRightFailsWithRetries) {
    ASSERT_EQ(run("--update").status, 0);
    suite("retries = 2\n");
    scene(".9");
    EXPECT_EQ(run().status, 1);
    folder.write("a.glib", "WindowSize 16 16\nSpere 1\n");
    EXPECT_EQ(run().status, 3);
}

#ifdef GLIBRA_END_IN_DRAW
TEST_F(NoisySuite, ADrawingThatEndsItsProcessIsRepeated) {
    ASSERT_EQ(run("--update").status, 0);
    const std::string once = preload(GLIBRA_END_IN_DRAW) + " GLIBRA_ENDED=ended GLIBRA_END_IN_DRAW=1";
    EXPECT_EQ(run("", once).status, 3) << "without retries it has crashed";
    suite("retries = 1\n[[shot]]\nname = \"b\"\nscript = \"a.glib\"\nmatch = \"a\"\ngolden = false\n");
    std::filesystem::remove(folder / "ended");
    const Finished flaky = run("--jobs 1 --only a", once);
    EXPECT_EQ(flaky.status, 0) << flaky.out << flaky.err;
    EXPECT_TRUE(contains(flaky.out, "drawing 2 is right; before: crashed, the process that drew it ended"))
        << flaky.out;
    std::filesystem::remove(folder / "ended");
    EXPECT_EQ(run("--strict-flaky --only a", once).status, 1);
}
#endif

#ifdef GLIBRA_END_ON_OPEN
TEST_F(NoisySuite, RetriesOfAShotThatAlwaysEndsItsProcessOrIsLateEnd) {
    for (const char* name : {"deadly.frag", "endless.frag"}) {
        folder.write(
            name,
            "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(gl_FragCoord.xy / 16., 0., 1.); }\n");
        folder.write("a.glib", std::string("WindowSize 16 16\nOrtho -1 1 -1 1\nFragment ") + name +
                                   "\nVertex a.vert\nProgram P\nSphere .5\n");
        folder.write(
            "a.vert",
            "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        suite("retries = 2\ntimeout = 2\n");
        ASSERT_EQ(run("--update").status, 0);
        const Finished end = run("", preload(GLIBRA_END_ON_OPEN));
        EXPECT_EQ(end.status, 3) << name << end.out << end.err;
        EXPECT_TRUE(contains(end.out, std::string("1 ") + (name[0] == 'd' ? "crashed" : "timed-out")))
            << end.out << end.err;
    }
}
#endif

TEST_F(NoisySuite, WithoutADriverTheJunitFileHasAnErrorForEachShot) {
    const Finished none =
        run("--driver egl --junit j.xml --report out", "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null");
    EXPECT_EQ(none.status, 4) << none.err;
    const std::string xml = readFile(folder / "j.xml");
    EXPECT_TRUE(contains(xml, "tests=\"1\" failures=\"0\" errors=\"1\"")) << xml;
    EXPECT_TRUE(contains(xml, "gpu-E01")) << xml;
    EXPECT_TRUE(contains(readFile(folder / "out/index.html"), "gpu-E01"));
}

TEST_F(NoisySuite, ASceneThatCannotBeDrawnIsAnErrorInJunitAndAPictureThatDiffersAFailure) {
    ASSERT_EQ(run("--update").status, 0);
    scene(".9");
    ASSERT_EQ(run("--junit j.xml").status, 1);
    EXPECT_TRUE(contains(readFile(folder / "j.xml"), "failures=\"1\" errors=\"0\""));
    folder.write("a.glib", "WindowSize 16 16\nSpere 1\n");
    ASSERT_EQ(run("--junit j.xml").status, 3);
    EXPECT_TRUE(contains(readFile(folder / "j.xml"), "failures=\"0\" errors=\"1\""));
}

TEST_F(NoisySuite, TheCommandThatItPrintsAccepts) {
    const auto acceptOf = [&](const Finished& failed) {
        const std::size_t at = failed.out.find("glibra test s.toml --only a --update");
        EXPECT_NE(at, std::string::npos) << failed.out;
        return at == std::string::npos ? std::string()
                                       : failed.out.substr(at + 7, failed.out.find('\n', at) - at - 7);
    };
    folder.write("a.glib", "WindowSize 16 16\n");  // one colour
    ASSERT_EQ(glibra(folder.path(), acceptOf(run())).status, 0);
    EXPECT_EQ(run().status, 0);
    folder.write("sub/s.toml", "goldens = \"../golden\"\n[[shot]]\nscript = \"../a.glib\"\n");
    scene(".4");
    const Finished outside = glibra(folder.path(), "test sub/s.toml");
    ASSERT_EQ(outside.status, 1);
    EXPECT_TRUE(contains(outside.out, "--update --allow-outside")) << outside.out;
}

TEST_F(NoisySuite, ListsItsShots) {
    suite("name = \"x\"\nsweep = { uA = [1, 2] }\ntags = [\"slow\"]\n[[shot]]\nscript = \"a.glib\"\n");
    folder.write("a.glib", "WindowSize 16 16\nUniform uA <0 1 2>\nSphere .5\n");
    EXPECT_EQ(run("--list").out, "s/x@uA=1\ns/x@uA=2\ns/a\n");
    EXPECT_EQ(run("--list --only tag:slow").out, "s/x@uA=1\ns/x@uA=2\n");
    EXPECT_EQ(run("--list --only nothing").status, 2);
    EXPECT_EQ(folder.listing(), "a.glib\ns.toml\n") << "nothing is written";
}

TEST_F(NoisySuite, AcceptsAFurtherPicture) {
    ASSERT_EQ(run("--update").status, 0);
    scene(".9");
    ASSERT_EQ(run("--update --also").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "golden/a.also1.png"));
    EXPECT_EQ(run().status, 0);
    scene(".5");
    EXPECT_EQ(run().status, 0);
    scene(".7");
    EXPECT_EQ(run().status, 1);
    EXPECT_EQ(run("--also").status, 2);
}

}  // namespace
}  // namespace glibra::test
