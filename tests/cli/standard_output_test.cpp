// "-" as the name of what a command writes: standard output where that is documented, wrong usage elsewhere.
// No command writes a file with that name.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace glibra::test {
namespace {

class StandardOutput : public testing::Test {
  protected:
    void SetUp() override {
        folder.write(
            "a.glib",
            "WindowSize 8 8\nTexture2D small 4 4 rgba8\nPass small clear {1 0 0}\nEndPass\nSphere\n");
        folder.write("s.toml", "[[shot]]\nscript = \"a.glib\"\n");
    }
    Finished run(const std::string& arguments) { return glibra(folder.path(), arguments); }

    Folder folder;
};

TEST_F(StandardOutput, StatsArePrinted) {
    const Finished one = run("render a.glib -o a.png --stats -");
    EXPECT_EQ(one.status, 0) << one.err;
    const nlohmann::json stats = nlohmann::json::parse(one.out, nullptr, false);
    ASSERT_TRUE(stats.is_object()) << one.out;
    EXPECT_EQ(stats["scene"], "a.glib") << one.out;
    folder.write("b.glib", "WindowSize 8 8\nBox 1\n");
    const Finished two = run("render a.glib b.glib -o out --stats -");
    const nlohmann::json both = nlohmann::json::parse(two.out, nullptr, false);
    ASSERT_TRUE(both.is_array()) << two.out;
    EXPECT_EQ(both.size(), 2U);
    EXPECT_EQ(folder.listing(), "a.glib\na.png\nb.glib\nout\ns.toml\n");
}

TEST_F(StandardOutput, TakesOnlyOneThing) {
    for (const std::string arguments : {"render a.glib -o - --stats -", "render - --stats - <a.glib",
                                        "render a.glib -o a.png --explain --stats -"}) {
        const Finished end = run(arguments);
        EXPECT_EQ(end.status, 2) << arguments;
        EXPECT_NE(end.err.find("--stats - writes to standard output"), std::string::npos) << end.err;
        EXPECT_EQ(end.out, "") << arguments;
    }
}

TEST_F(StandardOutput, IsRefusedWhereAFileOrFolderIsExpected) {
    for (const std::string arguments :
         {"render a.glib -o a.png --save small=-", "render --suite s.toml -o -", "test s.toml --results -",
          "test s.toml --report -", "test s.toml --junit -", "test s.toml --update --goldens -",
          "compare a.png a.png --heatmap -", "noise 1 -o -", "check a.glib --translated -",
          "class . --reference a.glib -o -"}) {
        const Finished end = run(arguments);
        EXPECT_EQ(end.status, 2) << arguments << end.err;
        EXPECT_NE(end.err.find("name a f"), std::string::npos) << arguments << end.err;
    }
    EXPECT_EQ(folder.listing(), "a.glib\ns.toml\n");
}

}  // namespace
}  // namespace glibra::test
