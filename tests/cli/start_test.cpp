// How the command line begins: glibra alone, scenes as its first word, unknown words and options, --help.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace glibra::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

constexpr const char* kNoDisplay = "DISPLAY= WAYLAND_DISPLAY=";

TEST(Start, GlibraAloneShowsWhatItCanDoInTenLines) {
    const Folder folder;
    const Finished run = glibra(folder.path(), "");
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.err, "");
    const std::vector<std::string> lines = linesOf(run.out);
    EXPECT_EQ(lines.size(), 10U);
    const auto examples = std::count_if(
        lines.begin(), lines.end(), [](const std::string& each) { return each.starts_with("  glibra "); });
    EXPECT_EQ(examples, 8);
}

/// True if this build has the program that the subcommand starts.
bool isBuilt(const std::string& subcommand) {
    const std::filesystem::path program = GLIBRA_PROGRAM;
    return std::filesystem::exists(program.parent_path() / ("glibra-" + subcommand));
}

TEST(Start, ASceneWithoutADisplayIsToldHowToRender) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    folder.write("all/b.glib", "Sphere\n");
    for (const char* words : {"a.glib", "view a.glib --paused"}) {
        const Finished run = glibra(folder.path(), words, kNoDisplay);
        EXPECT_EQ(run.status, 4) << words;
        EXPECT_TRUE(
            contains(run.err, "there is no display to open a window on; `glibra render a.glib` draws"))
            << run.err;
    }
    EXPECT_EQ(glibra(folder.path(), "all", kNoDisplay).status, 4);
    if (isBuilt("view")) {
        EXPECT_EQ(glibra(folder.path(), "view --help", kNoDisplay).status, 0);
    }
}

TEST(Start, ASceneThatDoesNotExistIsReportedWithTheNearestName) {
    const Folder folder;
    folder.write("teapot.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "teapto.glib", kNoDisplay);
    EXPECT_EQ(run.status, 3);
    EXPECT_EQ(run.err, "glibra: error: there is no file 'teapto.glib'; did you mean 'teapot.glib'?\n");
}

TEST(Start, AnUnknownCommandGetsASuggestion) {
    const Folder folder;
    const Finished near = glibra(folder.path(), "rendr a.glib");
    EXPECT_EQ(near.status, 2);
    EXPECT_TRUE(contains(near.err, "there is no command and no scene 'rendr'; did you mean 'render'?"))
        << near.err;
    const Finished far = glibra(folder.path(), "frobnicate");
    EXPECT_EQ(far.status, 2);
    EXPECT_FALSE(contains(far.err, "did you mean")) << far.err;
}

TEST(Start, AnUnknownOptionGetsASuggestionBeforeAnythingElse) {
    const Folder folder;
    folder.write("a.glib", "Sphere\n");
    const Finished run = glibra(folder.path(), "render a.glib --sise=8x8");
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err, "render has no option '--sise'; did you mean '--size'?")) << run.err;
    const Finished bare = glibra(folder.path(), "check --strickt");  // the scene is missing too
    EXPECT_TRUE(contains(bare.err, "check has no option '--strickt'; did you mean '--strict'?")) << bare.err;
    EXPECT_EQ(glibra(folder.path(), "check").status, 2);
    EXPECT_TRUE(contains(glibra(folder.path(), "check").err, "SCENE is missing"));
    EXPECT_TRUE(contains(glibra(folder.path(), "render a.glib --size").err, "--size needs a value: WxH"));
    EXPECT_TRUE(contains(glibra(folder.path(), "render --suite s.toml --time 1").err,
                         "cannot be given together with"));
}

TEST(Start, NoOptionTakesAnotherForItsValue) {
    const Folder folder;
    const std::regex withValue(R"(\n  (?:-[a-zA-Z],)?(--[-a-z]+) [A-Z])");
    for (const std::string command :
         {"render", "test", "check", "class", "gallery", "compare", "noise", "info"}) {
        const std::string help = glibra(folder.path(), command + " --help-all").out;
        int count = 0;
        for (std::sregex_iterator each(help.begin(), help.end(), withValue), end; each != end;
             ++each, ++count) {
            const std::string option = (*each)[1].str();
            const Finished run =
                glibra(folder.path(), std::string(command).append(" ").append(option).append(" --help"));
            EXPECT_EQ(run.status, 2) << command << option << run.out;
            EXPECT_TRUE(contains(run.err, option + ": expected ")) << run.err;
            EXPECT_TRUE(contains(run.err, "--help")) << run.err;
        }
        EXPECT_GT(count, 0) << command;
    }
    const Finished run = glibra(folder.path(), "render a.glib --stats -o a.png");
    EXPECT_TRUE(
        contains(run.err, "--stats: expected a value, found the option -o (./-o is a file of that name)"))
        << run.err;
}

TEST(Start, EveryHelpBeginsWithThreeExamplesAndHasNoLongLines) {
    const Folder folder;
    for (const std::string command :
         {"", "render", "test", "check", "class", "compare", "noise", "language", "info", "view", "bench"}) {
        if ((command == "view" || command == "bench") && !isBuilt(command)) continue;
        const Finished run = glibra(folder.path(), command + " --help", kNoDisplay);
        EXPECT_EQ(run.status, 0) << command;
        const std::vector<std::string> lines = linesOf(run.out);
        ASSERT_GE(lines.size(), 5U) << command << run.out;
        EXPECT_EQ(lines[0], "Examples:") << command;
        for (const std::size_t each : {1U, 2U, 3U})
            EXPECT_TRUE(lines[each].starts_with("  glibra")) << command << ": " << lines[each];
        EXPECT_EQ(lines[4], "") << command;
        EXPECT_FALSE(contains(run.out, "Excludes")) << command;
        EXPECT_FALSE(contains(run.out, "ENUM")) << command;
        EXPECT_FALSE(contains(run.out, "{auto")) << command;
    }
}

TEST(Start, RareOptionsAreListedByHelpAll) {
    const Folder folder;
    const Finished help = glibra(folder.path(), "render --help"),
                   all = glibra(folder.path(), "render --help-all");
    EXPECT_FALSE(contains(help.out, "--scene-transform")) << help.out;
    EXPECT_TRUE(contains(help.out, "--help-all lists")) << help.out;
    EXPECT_TRUE(contains(help.out, "--size"));
    EXPECT_EQ(all.status, 0);
    EXPECT_TRUE(contains(all.out, "--scene-transform")) << all.out;
    EXPECT_TRUE(contains(all.out, "--size"));
    EXPECT_FALSE(contains(all.out, "--help-all lists"));
    EXPECT_LT(linesOf(help.out).size(), linesOf(all.out).size());
}

TEST(Start, TheOptionViewIsCalledEyeAndKeepsItsOldName) {
    const Folder folder;
    folder.write("a.glib", "Sphere 1\n");
    for (const char* name : {"eye", "view"}) {
        EXPECT_EQ(glibra(folder.path(),
                         std::string("render a.glib --size 32x24 -o ") + name + ".png --" + name + " glman")
                      .status,
                  0)
            << name;
    }
    EXPECT_EQ(glibra(folder.path(), "render a.glib --size 32x24 -o auto.png").status, 0);
    EXPECT_EQ(readFile(folder / "eye.png"), readFile(folder / "view.png"));
    EXPECT_NE(readFile(folder / "eye.png"), readFile(folder / "auto.png"));
    const std::string help = glibra(folder.path(), "render --help").out;
    EXPECT_TRUE(contains(help, "--eye auto|glman")) << help;
    EXPECT_FALSE(contains(help, "--view")) << help;
}

}  // namespace
}  // namespace glibra::test
