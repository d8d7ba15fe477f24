// Whatever a command prints on standard output has arrived there if the command ends with status 0.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

class WholeOutput : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("a.glib", "WindowSize 16 16\nOrtho -1 1 -1 1\nSphere .5\n");
        folder.write("s.toml", "goldens = \"golden\"\n[[shot]]\nscript = \"a.glib\"\n");
        ASSERT_EQ(glibra(folder.path(), "render a.glib -o a.png").status, 0);
        ASSERT_EQ(glibra(folder.path(), "test s.toml --update --results parts/1").status, 0);
    }
    /// The braces keep the redirections of `arguments`.
    Finished run(const std::string& arguments) {
        return shell(folder.path(), "{ '" GLIBRA_PROGRAM "' " + arguments + "; }");
    }

    Folder folder;
};

/// At least one way to call each subcommand that prints, and each option that prints something else.
const std::vector<std::string> kPrinting{
    "",
    "--help",
    "--version",
    "render a.glib -o -",
    "render a.glib -o b.png --stats -",
    "render a.glib -o b.png --explain",
    "render - -o - < a.glib",
    "check a.glib --json",
#ifdef GLIBRA_VIEW_TESTED
    "view --help",
#endif
    "test s.toml",
    "test --merge parts/1",
    "class --help",
    "compare a.png a.png",
    "compare a.png a.png --json",
    "compare parts golden --json",
    "noise --help",
#ifdef GLIBRA_BENCH_TESTED
    "bench --list",
    "bench --help",
#endif
    "info",
    "info --json",
    "language",
    "language Sphere",
    "language glib-E27",
    "language mix",
    "language --diagnostics",
    "language --words",
    "language --markdown",
};

TEST_F(WholeOutput, IsAnErrorIfTheDiskIsFullOrTheDescriptorClosed) {
    for (const std::string& arguments : kPrinting) {
        const Finished whole = run(arguments);
        if (whole.out.empty()) {
            ADD_FAILURE() << arguments << " prints nothing: " << whole.err;
            continue;
        }
        for (const char* lost : {" > /dev/full", " >&-"}) {
            const Finished end = run(arguments + lost);
            EXPECT_GE(end.status, 3) << arguments << lost << end.err;
            EXPECT_TRUE(contains(end.err, "standard output")) << arguments << lost << end.err;
        }
    }
}

/// Commands that print nothing need no standard output.
TEST_F(WholeOutput, IsNotNeededByACommandWithoutOutput) {
    for (const std::string arguments : {"render a.glib -o b.png", "check a.glib", "noise 1 -o n.svg"})
        EXPECT_EQ(run(arguments + " >&-").status, 0) << arguments;
}

TEST_F(WholeOutput, TheListAboveHasEverySubcommand) {
    const std::string help = run("--help").out;
    std::set<std::string> commands;
    for (const std::string& each : kPrinting) commands.insert(each.substr(0, each.find(' ')));
    for (const char* each :
         {"render", "check", "view", "test", "class", "compare", "noise", "language", "bench", "info"})
        EXPECT_TRUE(contains(help, each)) << each;
    std::set<std::string> expected{"render",  "check", "test",     "class",
                                   "compare", "noise", "language", "info"};
#ifdef GLIBRA_VIEW_TESTED
    expected.insert("view");
#endif
#ifdef GLIBRA_BENCH_TESTED
    expected.insert("bench");
#endif
    for (const std::string& each : expected) EXPECT_TRUE(commands.contains(each)) << each;
}

}  // namespace
}  // namespace glibra::test
