// The exercises that come with glibra: each can be drawn beside its solution at the moments that its file
// names.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <sstream>
#include <string>

#include "../suite/folder.h"
#include "classroom/moments.h"

namespace glibra::classroom {
namespace {

namespace fs = std::filesystem;

TEST(Exercises, HaveASolutionWithEveryValueThatTheySweep) {
    int count = 0;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib/exercises")) {
        if (each.path().extension() != ".glib") continue;
        ++count;
        const std::string task = suite::textOf(each.path());
        std::istringstream lines(task);
        std::string line;
        std::getline(lines, line);
        EXPECT_TRUE(line.starts_with("# Exercise ")) << each.path();
        while (std::getline(lines, line) && line.starts_with('#'))
            EXPECT_LE(line.size(), 96U) << each.path() << ": the source panel is not wider: " << line;
        EXPECT_EQ(task.find("../"), std::string::npos)
            << each.path() << ": a copy elsewhere finds its files in the library";
        const fs::path file = fs::path(each.path()).replace_extension(".toml");
        const Result<std::vector<Moment>> moments = momentsOfSuite(file);
        ASSERT_TRUE(moments) << file << (moments.diagnostics.empty() ? "" : moments.diagnostics.front().text);
        ASSERT_FALSE(moments->empty()) << file;
        const fs::path& script = moments->front().shot.script;
        std::string solution = suite::textOf(script);
        if (const std::size_t at = solution.find("Include "); at != std::string::npos) {
            const std::string part = solution.substr(at + 8, solution.find('\n', at) - at - 8);
            solution += suite::textOf(script.parent_path() / part);
        }
        EXPECT_FALSE(solution.empty()) << file;
        for (const Moment& moment : *moments)
            for (const std::string& set : moment.shot.options.set) {
                const std::string name = set.substr(0, set.find('=')), value = set.substr(set.find('=') + 1);
                EXPECT_TRUE(solution.find(name + " <") != std::string::npos ||
                            solution.find(name + " {") != std::string::npos)
                    << file << ": " << set;
                const bool isWord = std::isalpha(static_cast<unsigned char>(value.front())) != 0;
                EXPECT_TRUE(!isWord || value == "true" || value == "false" ||
                            solution.find(value) != std::string::npos)
                    << file << ": " << set;
            }
    }
    EXPECT_GT(count, 60);
}

TEST(Exercises, MayHaveWordsWithoutQuotesAndNameTheirFileInMessages) {
    const suite::Folder folder;
    suite::writeText(folder / "a.glib", "Let shape <ball box>\nLet on <true>\n");
    const auto fileWith = [&](const std::string& sweep) {
        suite::writeText(folder / "task.toml", "solution = \"a.glib\"\nsweep = [" + sweep + "]\n");
        return momentsOfSuite(folder.path() / "task.toml");
    };
    const Result<std::vector<Moment>> moments =
        fileWith(R"("shape=[ball, 'box']", "on = [true, false]", "x = [1.5e3]")");
    ASSERT_TRUE(moments) << moments.diagnostics.front().text;
    ASSERT_EQ(moments->size(), 4U);
    EXPECT_EQ(moments->front().shot.options.set,
              (std::vector<std::string>{"shape=ball", "on=true", "x=1500"}));
    EXPECT_EQ(moments->back().shot.options.set,
              (std::vector<std::string>{"shape=box", "on=false", "x=1500"}));
    const Result<std::vector<Moment>> wrong = fileWith(R"("shape=[ball")");
    ASSERT_FALSE(wrong.diagnostics.empty());
    EXPECT_EQ(wrong.diagnostics.front().place.file, (folder.path() / "task.toml").string());
}

}  // namespace
}  // namespace glibra::classroom
