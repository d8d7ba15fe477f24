// The source line below an error on a terminal, and colours by NO_COLOR, CLICOLOR and CLICOLOR_FORCE.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "program.h"

namespace glibra::test {
namespace {

/// What `glibra ARGUMENTS` prints on a terminal, without carriage returns; empty if there is no script(1).
std::string onTerminal(const Folder& folder, const std::string& arguments,
                       const std::string& environment = {}) {
    if (shell(folder.path(), "command -v script").status != 0) return {};
    shell(folder.path(),
          "TERM=xterm " + environment + " script -qec '\"" GLIBRA_PROGRAM "\" " + arguments + "' typed");
    std::string text = readFile(folder / "typed");
    std::erase(text, '\r');
    return text;
}

class QuotedLines : public testing::Test {
  protected:
    QuotedLines() {
        folder.write(
            "a.vert",
            "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        folder.write("a.frag", "#version 330 core\nout vec4 f;\nvoid main() {\n\tf = vec4(colour, 1.);\n}\n");
        folder.write("a.glib", "Vertex a.vert\nFragment a.frag\nProgram P\nSphere\n");
        folder.write("b.glib", "Perspective 50\n  Spere 1\n");
        if (shell(folder.path(), "command -v script").status != 0) hasScript = false;
    }
    Folder folder;
    bool hasScript = true;
};

TEST_F(QuotedLines, ATerminalShowsTheLineWithACaret) {
    if (!hasScript) GTEST_SKIP() << "needs script(1)";
    for (const char* command : {"check", "render"}) {
        const std::string shader = onTerminal(folder, std::string(command) + " a.glib", "NO_COLOR=1");
        EXPECT_TRUE(contains(shader, "\n    4 |  f = vec4(colour, 1.);\n      |           ^\n")) << shader;
        const std::string scene = onTerminal(folder, std::string(command) + " b.glib", "NO_COLOR=1");
        EXPECT_TRUE(contains(scene, "\n    2 |   Spere 1\n      |   ^\n")) << scene;
    }
}

TEST_F(QuotedLines, ALogHasOneLinePerMessage) {
    const Finished run = glibra(folder.path(), "check a.glib");
    EXPECT_TRUE(contains(run.err, "a.frag:4:")) << run.err;
    EXPECT_FALSE(contains(run.err, " | ")) << run.err;
}

TEST_F(QuotedLines, AFileOutsideOfTheScenesFolderIsNotQuoted) {
    if (!hasScript) GTEST_SKIP() << "needs script(1)";
    folder.write("secret.frag", "TOP_SECRET one\nTOP_SECRET two\n");
    folder.write("in/a.vert", readFile(folder / "a.vert"));
    folder.write("in/s.glib", "Vertex a.vert\nFragment ../secret.frag\nProgram P\nSphere\n");
    for (const char* how : {"", " --untrusted"}) {
        const std::string text = onTerminal(folder, std::string("check in/s.glib") + how, "NO_COLOR=1");
        EXPECT_TRUE(contains(text, "secret.frag")) << text;
        EXPECT_FALSE(contains(text, "TOP_SECRET")) << text;
    }
}

TEST_F(QuotedLines, LongLinesAreCutAroundTheCaret) {
    if (!hasScript) GTEST_SKIP() << "needs script(1)";
    folder.write("b.glib", std::string(500, ' ') + "Spere " + std::string(500, '1') + "\n");
    const std::string text = onTerminal(folder, "check b.glib", "NO_COLOR=1");
    const std::size_t at = text.find("    1 | ");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_LT(text.find('\n', at) - at, 120U);
    EXPECT_TRUE(contains(text.substr(at), "Spere ")) << text;
}

TEST_F(QuotedLines, ColorsObeyTheEnvironment) {
    const auto isColored = [](const std::string& text) { return contains(text, "\033[1;31m"); };
    EXPECT_FALSE(isColored(glibra(folder.path(), "check b.glib").err));
    EXPECT_TRUE(isColored(glibra(folder.path(), "check b.glib", "CLICOLOR_FORCE=1").err));
    EXPECT_FALSE(isColored(glibra(folder.path(), "check b.glib", "CLICOLOR_FORCE=0").err));
    EXPECT_FALSE(isColored(glibra(folder.path(), "check b.glib", "CLICOLOR_FORCE=1 NO_COLOR=1").err));
    EXPECT_TRUE(contains(glibra(folder.path(), "test . --results r", "CLICOLOR_FORCE=1").out, "\033[1;31m"));
    if (!hasScript) GTEST_SKIP() << "needs script(1)";
    EXPECT_TRUE(isColored(onTerminal(folder, "check b.glib")));
    for (const char* off : {"NO_COLOR=1", "CLICOLOR=0", "TERM=dumb"})
        EXPECT_FALSE(isColored(onTerminal(folder, "check b.glib", off))) << off;
}

TEST_F(QuotedLines, ATestNamesEachFailureOnce) {
    folder.write("bad/b.glib", "Spere 1\n");
    const Finished apart = glibra(folder.path(), "test bad --results r");
    EXPECT_TRUE(contains(apart.err, "failed: bad/b")) << apart.err;  // while it runs
    const Finished together = shell(folder.path(), "'" GLIBRA_PROGRAM "' test bad --results r 2>&1");
    const std::size_t first = together.out.find("bad/b");
    ASSERT_NE(first, std::string::npos) << together.out;
    EXPECT_FALSE(contains(together.out, "failed: bad/b")) << together.out;
}

}  // namespace
}  // namespace glibra::test
