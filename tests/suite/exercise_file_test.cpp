// The files beside the scenes that exercises begin with.

#include "suite/file/sweep.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>

namespace glibra::suite::test {
namespace {

namespace fs = std::filesystem;

TEST(ExerciseFile, NamesTheSolutionAndWhatIsDrawn) {
    const auto exercise = readExerciseText(
        "solution = \"../../a/b.glib\"\ntimes = [0, 1.5]\nsweep = [\"x=[1, 2]\"]\n", "g/e/c/t.toml");
    ASSERT_TRUE(exercise);
    EXPECT_EQ(exercise->solution, "g/a/b.glib");
    EXPECT_EQ(exercise->times, (std::vector<double>{0, 1.5}));
    EXPECT_EQ(exercise->sweeps, std::vector<std::string>{"x=[1, 2]"});
    EXPECT_FALSE(exercise->has);
    const auto free = readExerciseText(
        "solution = \"a.glib\"\nhas = { color = [1, 0.5, 0], within = 0.1, least = 0.2, most = 0.3 }\n",
        "t.toml");
    ASSERT_TRUE(free && free->has);
    EXPECT_EQ(free->has->color, (std::array<double, 3>{1, .5, 0}));
    EXPECT_EQ(free->has->within, .1);
    EXPECT_EQ(free->has->least, .2);
    EXPECT_EQ(free->has->most, .3);
    const auto least = readExerciseText("solution = \"/a.glib\"\ntimes = 3\nsweep = \"y=[1]\"\n", "t.toml");
    ASSERT_TRUE(least);
    EXPECT_EQ(least->solution, "/a.glib");
    EXPECT_EQ(least->times, std::vector<double>{3});
    EXPECT_EQ(least->sweeps, std::vector<std::string>{"y=[1]"});
}

TEST(ExerciseFile, IsNoSuite) {
    EXPECT_TRUE(isExercise("solution = 3"));
    for (const char* each : {"", "[[shot]]\nscript = \"a.glib\"\n", "solution", "[x]\nsolution = \"a\"\n"})
        EXPECT_FALSE(isExercise(each)) << each;
}

TEST(ExerciseFile, MistakesAreReported) {
    const auto idOf = [](const char* text) {
        const auto read = readExerciseText(text, "t.toml");
        EXPECT_FALSE(read) << text;
        return read.diagnostics.empty() ? std::string() : read.diagnostics.front().id;
    };
    EXPECT_EQ(idOf("solution = 3\n"), "suite-E03");
    EXPECT_EQ(idOf("solution = \"a.glib\"\ntime = 3\n"), "suite-E02");
    EXPECT_EQ(idOf("solution = \"a.glib\"\ntimes = [\"x\"]\n"), "suite-E03");
    EXPECT_EQ(idOf("solution = \"a.glib\"\nsweep = [1]\n"), "suite-E03");
    for (const char* each : {"3", "{ color = [1, 0] }", "{ color = [1, 0, \"x\"] }", "{ least = \"x\" }"})
        EXPECT_EQ(idOf(("solution = \"a.glib\"\nhas = " + std::string(each) + "\n").c_str()), "suite-E03")
            << each;
    EXPECT_EQ(idOf("solution = \"a.glib\"\nhas = { colour = [1, 0, 0] }\n"), "suite-E02");
    EXPECT_EQ(idOf("solution = \"a.glib\n"), "suite-E01");
    EXPECT_TRUE(readExerciseText("solution = \"a.glib\"\ntime = 3\n", "t.toml")
                    .diagnostics.front()
                    .text.starts_with("unknown key 'time' in an exercise; "));
}

TEST(ExerciseFile, EveryShippedOneIsRead) {
    int count = 0;
    for (const auto& each :
         fs::recursive_directory_iterator(fs::path(GLIBRA_SOURCE_DIR) / "glib/exercises")) {
        if (each.path().extension() != ".glib") continue;
        const auto exercise = readExercise(exerciseFileOf(each.path()));
        ASSERT_TRUE(exercise) << each.path();
        EXPECT_TRUE(fs::is_regular_file(exercise->solution)) << each.path();
        ++count;
    }
    EXPECT_GT(count, 70);
}

}  // namespace
}  // namespace glibra::suite::test
