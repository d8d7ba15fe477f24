// A run survives killed workers, Ctrl-C, a full disk, goldens that cannot be written, and a second run in the
// same folder.

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <sstream>

#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

/// Shots that take long enough to be interrupted.
class Survival : public testing::Test {
  protected:
    static constexpr int kShots = 12;

    void SetUp() override {
        folder.write("a.vert",
                     "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
        folder.write("a.frag",
                     "#version 330 core\nuniform int uRounds;\nout vec4 f;\nvoid main() {\n"
                     "  vec2 z = gl_FragCoord.xy / 300.;\n  for (int i = 0; i < uRounds; i++) z = sin(z * "
                     "3.1 + float(i));\n"
                     "  uint h = uint(gl_FragCoord.x) * 1664525u + uint(gl_FragCoord.y) * 22695477u;\n"
                     "  h = (h ^ (h >> 15)) * 2246822519u;\n  f = vec4(z, float(h >> 24) / 255., 1.);\n}\n");
        folder.write("a.glib",
                     "Vertex a.vert\nFragment a.frag\nProgram P uRounds <1 200 5000>\nQuadXY 0 1 1 1\n");
        std::string rounds;
        for (int i = 0; i < kShots; ++i) rounds += (i > 0 ? ", " : "") + std::to_string(200 + i);
        folder.write("s.toml",
                     "goldens = \"golden\"\n[defaults]\nsize = [300, 300]\n[[shot]]\nscript = "
                     "\"a.glib\"\nsweep = { uRounds = [" +
                         rounds + "] }\n");
    }
    Finished run(const std::string& arguments) { return glibra(folder.path(), "test " + arguments); }
    /// Runs a shell script in the folder, with $GLIBRA set. Returns the exit status, which is 124 after ten
    /// minutes.
    int shell(const std::string& script) {
        folder.write("script.sh", "GLIBRA='" GLIBRA_PROGRAM "'\n" + script);
        const int status = std::system(
            ("cd '" + folder.path().string() + "' && timeout 600 sh script.sh >log 2>&1").c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    std::string log() { return readFile(folder / "log"); }
    /// The names of all temporary files that were left.
    std::string leftovers() {
        std::string names;
        for (const auto& each : fs::recursive_directory_iterator(folder.path()))
            if (each.path().filename().string().starts_with(".glibra-")) names += each.path().string() + "\n";
        return names;
    }

    Folder folder;
};

std::string count(int n, const std::string& word) {
    return std::to_string(n) + " " + word;
}

/// The lines that end with an id, without the lines of progress.
std::string diagnosticsIn(const std::string& text) {
    std::string found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.ends_with("]")) found += line + "\n";
    return found;
}

TEST_F(Survival, AKilledWorkerCostsOneShotAndTheRestGoesOn) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    // A worker between two shots may be killed without consequence; then the test tries again.
    int status = 0;
    for (int i = 0; i < 5 && status == 0; ++i)
        status = shell(
            "rm -rf glibra-results\n\"$GLIBRA\" test s.toml --jobs 1 & parent=$!\n"
            "until [ -s glibra-results/results.jsonl ] && worker=$(pgrep -P $parent); do sleep .01; done\n"
            "kill -9 $worker\nwait $parent\n");
    EXPECT_EQ(status, 3) << log();
    EXPECT_TRUE(contains(log(), "1 crashed, " + count(kShots - 1, "passed"))) << log();
    EXPECT_TRUE(contains(log(), "signal 9")) << log();
}

#ifdef GLIBRA_END_ON_OPEN
TEST_F(Survival, AShotThatEndsItsWorkerWhileItIsPreparedIsTheOneThatIsBlamed) {
    folder.write("deadly.frag", readFile(folder / "a.frag"));
    folder.write("b.glib", "Vertex a.vert\nFragment deadly.frag\nProgram P uRounds 200\nQuadXY 0 1 1 1\n");
    folder.write("t.toml",
                 "goldens = \"golden\"\n[defaults]\nsize = [300, 300]\n"
                 "[[shot]]\nscript = \"a.glib\"\nsweep = { uRounds = [200, 201, 202] }\n"
                 "[[shot]]\nscript = \"b.glib\"\n"
                 "[[shot]]\nscript = \"a.glib\"\nsweep = { uRounds = [203, 204] }\n");
    ASSERT_EQ(run("t.toml --update").status, 0);
    for (const std::string jobs : {"1", "2"}) {
        const Finished end = glibra(folder.path(), "test t.toml --jobs " + jobs, preload(GLIBRA_END_ON_OPEN));
        EXPECT_EQ(end.status, 3) << end.out << end.err;
        EXPECT_TRUE(contains(end.out, "1 crashed, 5 passed")) << end.out << end.err;
        EXPECT_TRUE(
            contains(end.out + end.err, "b.glib:1:1: error: the process that drew it ended with signal 6"))
            << end.out << end.err;
    }
}
#endif

#ifdef GLIBRA_END_ON_OPEN
/// Finding its files, preparing it while others are drawn, and drawing it each take the time of the shot.
TEST_F(Survival, AShotThatNeverEndsTakesItsOwnTimeAndNobodyElses) {
    folder.write("endless.frag", readFile(folder / "a.frag"));
    folder.write("b.glib", "Vertex a.vert\nFragment endless.frag\nProgram P uRounds 200\nQuadXY 0 1 1 1\n");
    const std::string shot = "[[shot]]\nscript = \"a.glib\"\nset = { uRounds = 200 }\nname = ";
    for (const std::string first : {"match = \"last\"\n", ""}) {
        folder.write("t.toml", "goldens = \"golden\"\n[defaults]\nsize = [30, 30]\n" + shot + "\"first\"\n" +
                                   first + "[[shot]]\nscript = \"b.glib\"\ntimeout = 4\n" + shot +
                                   "\"last\"\n");
        ASSERT_EQ(run("t.toml --update").status, 0);
        for (const std::string jobs : {"1", "2"}) {
            const auto start = std::chrono::steady_clock::now();
            const Finished end =
                glibra(folder.path(), "test t.toml --jobs " + jobs, preload(GLIBRA_END_ON_OPEN));
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
            EXPECT_EQ(end.status, 3) << end.out << end.err;
            EXPECT_TRUE(contains(end.out, "1 timed-out, 2 passed")) << end.out << end.err;
            EXPECT_TRUE(contains(end.out + end.err, "b.glib:1:1: error: not drawn within 4 seconds"))
                << end.out << end.err;
            EXPECT_LT(taken.count(), 100) << "the limit of other shots is 300 seconds";
        }
    }
}
#endif

#ifdef GLIBRA_END_IN_DRAW
TEST_F(Survival, ADriverThatDiesInTheMiddleOfASuiteCostsOneShot) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    for (const std::string jobs : {"1", "2"})
        for (const std::string draw : {"1", "4"}) {
            fs::remove(folder / "ended");
            const Finished end =
                glibra(folder.path(), "test s.toml --jobs " + jobs,
                       preload(GLIBRA_END_IN_DRAW) + " GLIBRA_ENDED=ended GLIBRA_END_IN_DRAW=" + draw);
            ASSERT_TRUE(fs::exists(folder / "ended")) << "no process has drawn so often";
            EXPECT_EQ(end.status, 3) << end.out << end.err;
            EXPECT_TRUE(contains(end.out, "1 crashed, " + count(kShots - 1, "passed"))) << end.out << end.err;
            EXPECT_TRUE(contains(end.out + end.err,
                                 "a.glib:1:1: error: the process that drew it ended with signal 6"))
                << end.out << end.err;
        }
}
#endif

TEST_F(Survival, ABatchIsTheSameWhatEverIsPreparedBesideIt) {
    folder.write("c.frag",
                 "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(fract(gl_FragCoord.xy / 31.), "
                 "fract(Timer), 1.); }\n");
    folder.write("b.glib", "Vertex a.vert\nFragment c.frag\nProgram P uMistake 1\nQuadXY 0 1 1 1\n");
    folder.write("d.glib", "Vertex a.vert\nFragment nothing.frag\nProgram P\nQuadXY 0 1 1 1\n");
    std::string suite = "[defaults]\nsize = [60, 40]\n";
    for (int i = 0; i < 9; ++i)
        suite += "[[shot]]\nname = \"s" + std::to_string(i) + "\"\nscript = \"" + "abd"[i % 3] +
                 ".glib\"\ntime = " + std::to_string(i / 2) + "\n";
    folder.write("t.toml", suite);
    const Finished batch = glibra(folder.path(), "render --suite t.toml -o batch --jobs 1");
    EXPECT_EQ(batch.status, 3);
    std::string messages;
    for (int i = 0; i < 9; ++i) {
        const std::string name = "s" + std::to_string(i);
        const Finished alone =
            glibra(folder.path(), "render --suite t.toml -o alone --jobs 1 --only " + name);
        messages += diagnosticsIn(alone.err);
        EXPECT_EQ(fs::exists(folder / ("batch/" + name + ".png")), i % 3 != 2) << name;
        if (i % 3 == 2) continue;
        EXPECT_EQ(readFile(folder / ("batch/" + name + ".png")),
                  readFile(folder / ("alone/" + name + ".png")))
            << name;
    }
    EXPECT_FALSE(messages.empty());
    EXPECT_EQ(diagnosticsIn(batch.err), messages);
}

TEST_F(Survival, CtrlCLeavesWholeFilesAndResumeDoesTheRest) {
    // Background jobs of the shell ignore SIGINT; env restores the signal.
    const int status = shell(
        "env --default-signal=INT \"$GLIBRA\" test s.toml --update --jobs 1 & parent=$!\n"
        "until ls golden/*.png; do sleep .01; done\nkill -INT $parent\nwait $parent\n");
    EXPECT_EQ(status, 130) << log();
    EXPECT_TRUE(contains(log(), "skipped")) << log();
    EXPECT_EQ(leftovers(), "");
    const Finished rest = run("s.toml --update --resume");
    EXPECT_EQ(rest.status, 0) << rest.out;
    // A golden that was written without its result is compared.
    EXPECT_TRUE(contains(rest.out, count(kShots, "updated")) ||
                contains(rest.out, count(kShots - 1, "updated") + ", 1 passed"))
        << rest.out;
    EXPECT_TRUE(contains(run("s.toml").out, count(kShots, "passed")));
}

TEST_F(Survival, ResumeAfterAnUpdateComparesInsteadOfRepeatingThatThereWasOne) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    EXPECT_TRUE(contains(run("s.toml --update --resume").out, count(kShots, "updated")));
    EXPECT_TRUE(contains(run("s.toml --resume").out, count(kShots, "passed")));
}

TEST_F(Survival, AKilledRunContinuesWithWhatIsMissing) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    shell(
        "rm -r glibra-results\n\"$GLIBRA\" test s.toml --jobs 1 & parent=$!\n"
        "until [ $(cat glibra-results/results.jsonl | wc -l) -gt 3 ]; do sleep .01; done\nkill -9 $parent\n"
        "wait $parent\ncp glibra-results/results.jsonl before\n");
    const std::string before = readFile(folder / "before");
    const Finished rest = run("s.toml --resume");
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_TRUE(contains(rest.out, count(kShots, "passed"))) << rest.out;
    // Earlier lines stay as they were, including their times.
    const std::string after = readFile(folder / "glibra-results/results.jsonl");
    const std::size_t begin = before.find('\n') + 1;
    const std::string line = before.substr(begin, before.find('\n', begin) - begin);
    EXPECT_TRUE(contains(after, line)) << line;
}

TEST_F(Survival, AMergeOfKilledRunsIsAnErrorUntilTheyAreResumed) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    // Shard 1 is killed after one result, shard 2 after three.
    shell(
        "for shard in 1 2; do\n"
        "  \"$GLIBRA\" test s.toml --shard $shard/2 --results r$shard --jobs 1 & run=$!\n"
        "  until [ $(cat r$shard/results.jsonl | wc -l) -gt $((shard * 2 - 1)) ]; do sleep .01; done\n"
        "  kill -9 $run\n  wait $run\ndone\n");
    const Finished early = run("--merge r1 r2 --results all --junit j.xml --report page");
    EXPECT_EQ(early.status, 3) << early.out;
    EXPECT_TRUE(contains(early.err, "result-E03")) << early.err;
    EXPECT_TRUE(contains(early.err, "planned shots have no verdict")) << early.err;
    EXPECT_TRUE(contains(early.out, "incomplete: ")) << early.out;
    EXPECT_TRUE(contains(readFile(folder / "j.xml"), "<error message=")) << readFile(folder / "j.xml");
    EXPECT_TRUE(contains(readFile(folder / "page/index.html"), "planned shots have no verdict"));
    for (const std::string shard : {"1", "2"})
        EXPECT_EQ(run("s.toml --shard " + shard + "/2 --resume --results r" + shard).status, 0);
    const Finished whole = run("--merge r1 r2 --results all");
    EXPECT_EQ(whole.status, 0) << whole.err;
    EXPECT_TRUE(contains(whole.out, count(kShots, "passed"))) << whole.out;
}

TEST_F(Survival, AMergeOfAnInterruptedRunIsAnError) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    const int status = shell(
        "rm -r glibra-results\nenv --default-signal=INT \"$GLIBRA\" test s.toml --jobs 1 & parent=$!\n"
        "until [ $(cat glibra-results/results.jsonl | wc -l) -gt 2 ]; do sleep .01; done\n"
        "kill -INT $parent\nwait $parent\n");
    EXPECT_EQ(status, 130) << log();
    const Finished merged = run("--merge glibra-results --results all");
    EXPECT_EQ(merged.status, 3) << merged.out;
    EXPECT_TRUE(contains(merged.err, "result-E03")) << merged.err;
}

TEST_F(Survival, TwoRunsInOneFolderBothGiveRightResults) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    const int status = shell(
        "\"$GLIBRA\" test s.toml >one 2>&1 & a=$!\n\"$GLIBRA\" test s.toml >two 2>&1 & b=$!\n"
        "wait $a && wait $b\n");
    EXPECT_EQ(status, 0) << readFile(folder / "one") << readFile(folder / "two");
    for (const char* each : {"one", "two"})
        EXPECT_TRUE(contains(readFile(folder / each), count(kShots, "passed"))) << each;
    EXPECT_EQ(leftovers(), "");
}

TEST_F(Survival, AMergeIntoTheFolderOfARunIsRefused) {
    ASSERT_EQ(run("s.toml --update --results part").status, 0);
    const int status = shell(
        "mkdir glibra-results\nflock glibra-results sleep 60 & lock=$!\nwhile flock -n glibra-results true; "
        "do sleep 0.05; done\n"
        "\"$GLIBRA\" test --merge part --results glibra-results >merged 2>&1\ncode=$?\nkill $lock\nexit "
        "$code\n");
    EXPECT_EQ(status, 3) << log();
    EXPECT_TRUE(contains(readFile(folder / "merged"), "result-E02")) << readFile(folder / "merged");
}

TEST_F(Survival, APowerLossThatLeavesZerosCostsOneResult) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    std::string results = readFile(folder / "glibra-results/results.jsonl");
    results.resize(results.rfind("{\"end\""));  // the run had not ended
    results.resize(results.size() - 40);
    folder.write("glibra-results/results.jsonl", results + std::string(4096, '\0'));
    const Finished rest = run("s.toml --resume");
    EXPECT_EQ(rest.status, 0) << rest.err;
    EXPECT_TRUE(contains(rest.out, count(kShots, "passed"))) << rest.out;
}

TEST_F(Survival, AFolderOfResultsWithLinksGetsNothingWrittenThroughThem) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    folder.write("mine/a@uRounds=200.got.png", "mine");
    fs::create_directories(folder / "r");
    fs::create_directory_symlink(folder / "mine", folder / "r/s");
    folder.write("a.glib",
                 "Vertex a.vert\nFragment a.frag\nProgram P uRounds <1 200 5000>\nQuadXY 0 .5 1 1\n");
    EXPECT_NE(run("s.toml --results r --only '*=200'").status, 0);
    EXPECT_EQ(readFile(folder / "mine/a@uRounds=200.got.png"), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "mine"), {}), 1);
}

TEST_F(Survival, TwoUpdatesAtOnceLeaveWholeGoldensAndAllHashes) {
    const int status = shell(
        "\"$GLIBRA\" test s.toml --update --results r1 & a=$!\n\"$GLIBRA\" test s.toml --update --results r2 "
        "& b=$!\n"
        "wait $a && wait $b\n");
    EXPECT_EQ(status, 0) << log();
    const Finished check = run("s.toml");
    EXPECT_EQ(check.status, 0) << check.out;
    const std::string results = readFile(folder / "glibra-results/results.jsonl");
    EXPECT_FALSE(contains(results, "\"exact\":false")) << "a hash is missing";
    EXPECT_EQ(leftovers(), "");
}

TEST_F(Survival, ATruncatedGoldenFailsItsShotOnly) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    fs::resize_file(folder / "golden/a@uRounds=205.png", 500);
    const Finished broken = run("s.toml");
    EXPECT_EQ(broken.status, 1);
    EXPECT_TRUE(contains(broken.out, "golden/a@uRounds=205.png")) << broken.out;
    EXPECT_TRUE(contains(broken.out, "1 failed, " + count(kShots - 1, "passed"))) << broken.out;
    EXPECT_EQ(run("s.toml --update").status, 1) << "a golden that cannot be read is kept";
    EXPECT_EQ(run("s.toml --update --replace-unreadable").status, 0);
    EXPECT_EQ(run("s.toml").status, 0);
}

TEST_F(Survival, GoldensThatCannotBeWrittenAreReportedAndStay) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    const std::string before = readFile(folder / "golden/a@uRounds=200.png");
    folder.write("a.frag",
                 "#version 330 core\nuniform int uRounds;\nout vec4 f;\nvoid main() { f = vec4(fract(float("
                 "uRounds) * gl_FragCoord.xy / 500.), 0., 1.); }\n");
    // Root may write anywhere, so another user has to try.
    const bool root = ::geteuid() == 0;
    const std::string user = root ? "setpriv --reuid=65534 --clear-groups " : "";
    const int status =
        shell("chmod 755 . && chmod -R a-w golden && mkdir out && chmod 777 out\n" + user +
              "\"$GLIBRA\" test s.toml --update --results out/r\ncode=$?\nchmod -R u+w golden\nexit $code\n");
    if (contains(log(), "setpriv")) GTEST_SKIP() << log();
    EXPECT_EQ(status, 1) << log();
    EXPECT_TRUE(contains(log(), "permission denied")) << log();
    EXPECT_TRUE(contains(log(), count(kShots, "failed"))) << log();
    EXPECT_EQ(readFile(folder / "golden/a@uRounds=200.png"), before);
    EXPECT_EQ(leftovers(), "");
}

TEST_F(Survival, AFullDiskIsReportedAndNothingIsHalfWritten) {
    if (shell("mkdir small && mount -t tmpfs -o size=256k tmpfs small\n") != 0)
        GTEST_SKIP() << "mounting is not permitted: " << log();
    const int status = shell(
        "\"$GLIBRA\" test s.toml --update --goldens small/g --results r; echo status $?\n"
        "ls -la small/g/s\nfor i in small/g/s/*.png; do tail -c 8 $i | grep -q IEND || echo torn $i; done\n"
        "umount small\n");
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(contains(log(), "o space left on device")) << log();
    EXPECT_FALSE(contains(log(), "torn")) << log();
    EXPECT_FALSE(contains(log(), ".glibra-")) << log();
    EXPECT_FALSE(contains(log(), "status 0")) << log();
}

TEST_F(Survival, AFullDiskUnderTheResultsStopsTheRun) {
    ASSERT_EQ(run("s.toml --update").status, 0);
    if (shell("mkdir small && mount -t tmpfs -o size=16k tmpfs small\n") != 0)
        GTEST_SKIP() << "mounting is not permitted: " << log();
    shell(
        "dd if=/dev/zero of=small/fill bs=1k count=8\n"
        "\"$GLIBRA\" test s.toml --results small; echo status $?\numount small\n");
    EXPECT_TRUE(contains(log(), "o space left on device")) << log();
    EXPECT_TRUE(contains(log(), "status 3")) << log();
}

}  // namespace
}  // namespace glibra::test
