// A folder that cannot be listed may have scenes. No command ends as if there were none.

#include <gtest/gtest.h>

#include <string>

#include "program.h"

#ifdef GLIBRA_REFUSE_FOLDER

namespace glibra::test {
namespace {

class UnlistedFolder : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* each : {"all/a.glib", "all/locked/b.glib", "reference.glib", "class/ana/a.glib",
                                 "class/bob/locked/b.glib", "class/locked_c/c.glib"})
            folder.write(each, "WindowSize 8 8\nOrtho -1 1 -1 1\nSphere .5\n");
        folder.write("deep.toml", "[[shot]]\nscript = \"all/**/*.glib\"\n");
        folder.write("part.toml", "[[shot]]\nscript = \"all/*/*.glib\"\n");
        folder.write("except.toml", "[[shot]]\nscript = \"all/a.glib\"\nexcept = \"all/locked/*.glib\"\n");
        folder.write("pictures/locked/a.png", "");
        folder.write("pictures/b.png", "");
    }
    Finished run(const std::string& arguments) {
        return glibra(folder.path(), arguments, preload(GLIBRA_REFUSE_FOLDER));
    }

    Folder folder;
};

TEST_F(UnlistedFolder, IsAnErrorForEveryCommandThatSearches) {
    for (const std::string arguments :
         {"check all", "render all -o out", "test all", "test deep.toml", "test part.toml",
          "test except.toml", "render --suite deep.toml -o out", "compare pictures pictures"}) {
        const Finished end = run(arguments);
        EXPECT_EQ(end.status, 3) << arguments << end.err;
        EXPECT_TRUE(contains(end.err, "[suite-E22]")) << arguments << end.err;
        EXPECT_TRUE(contains(end.err, "Permission denied")) << arguments << end.err;
    }
}

TEST_F(UnlistedFolder, IsNamedOnThePageOfAClass) {
    const Finished end = run("class class --reference reference.glib -o site");
    EXPECT_EQ(end.status, 3) << end.err;
    for (const char* each : {"bob", "locked_c"})
        EXPECT_TRUE(contains(end.err, std::string(each) + ": ")) << each << end.err;
    EXPECT_TRUE(contains(end.err, "cannot be listed")) << end.err;
    EXPECT_TRUE(contains(readFile(folder / "site/index.html"), "cannot be listed"));
}

TEST_F(UnlistedFolder, DoesNoHarmElsewhere) {
    EXPECT_EQ(run("check all/a.glib").status, 0);
    folder.write("one.toml", "[[shot]]\nscript = \"all/*.glib\"\n");
    EXPECT_FALSE(contains(run("test one.toml").err, "suite-E22"));
}

/// A link that leads nowhere matches the pattern, but there is nothing to draw.
TEST_F(UnlistedFolder, ALinkToNothingIsAnErrorToo) {
    folder.write("links/a.glib", "Sphere\n");
    ASSERT_EQ(
        shell(folder.path(), "ln -s nowhere.glib links/b.glib && ln -s nowhere.png pictures/c.png").status,
        0);
    for (const std::string arguments : {"check links", "test links", "compare pictures pictures"}) {
        const Finished end = glibra(folder.path(), arguments);
        EXPECT_EQ(end.status, 3) << arguments << end.err;
        EXPECT_TRUE(contains(end.err, "the target of the link is missing")) << arguments << end.err;
    }
}

}  // namespace
}  // namespace glibra::test

#endif
