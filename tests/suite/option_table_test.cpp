// Tests of the options of a picture: what is written for a shot is read back unchanged.

#include "suite/options/option_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "option_samples.h"
#include "suite/options/option_words.h"
#include "suite/report/terminal_report.h"
#include "suite_text.h"

namespace glibra::suite {
namespace {

/// The words into which a POSIX shell splits a command line.
std::vector<std::string> shellWords(const std::string& command) {
    std::vector<std::string> words;
    std::FILE* pipe = ::popen(("printf '%s\\n' " + command).c_str(), "r");
    if (!pipe) return words;
    std::string word;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
        if (c != '\n') {
            word += static_cast<char>(c);
        } else {
            words.push_back(word);
            word.clear();
        }
    }
    ::pclose(pipe);
    return words;
}

/// The options that `glibra render SCENE OPTION... [-o FILE]` reads.
Shot parsed(const std::string& command) {
    Shot shot;
    const std::vector<std::string> words = shellWords(command);
    for (std::size_t i = 3; i < words.size(); ++i) {  // after "glibra render SCENE"
        if (words[i] == "-o") {
            shot.options.floatPixels = words.at(++i).ends_with(".exr");
            continue;
        }
        const OptionRow* row = words[i].starts_with("--") ? findOption(words[i].substr(2)) : nullptr;
        if (!row) {
            ADD_FAILURE() << "unknown word " << words[i];
            continue;
        }
        const bool isFlag = std::holds_alternative<FlagValue>(row->value);
        EXPECT_EQ(readOptionText(*row, isFlag ? "" : words.at(++i), shot), "") << command;
    }
    return shot;
}

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

/// Gives `to` the value that `from` has.
void copyOption(const OptionRow& row, const Shot& from, Shot& to) {
    std::visit(Overloaded{[&](const SizeValue& size) {
                              size.width.edit(to) = size.width.get(from);
                              size.height.edit(to) = size.height.get(from);
                          },
                          [&](const WordValue& word) { word.set(to, word.get(from)); },
                          [&](const auto& value) { value.member.edit(to) = value.member.get(from); }},
               row.value);
}

void expectSurvives(Shot before, const std::string& what) {
    const test::SceneFolder folder({"a.glib", "lib one/x", "lib two/x"});
    for (std::filesystem::path& each : before.options.libraryRoots) each = folder.path() / each;
    const std::string lines = optionLines(before, folder.path());
    const Result<Suite> suite = folder.read("[[shot]]\nscript = \"a.glib\"\n" + lines);
    ASSERT_TRUE(suite) << what << "\n" << lines << folder.shown(suite);
    Shot read = suite->shots.at(0);
    for (const OptionRow& row : optionTable())  // suites cannot state these
        if (row.key.empty()) copyOption(row, before, read);
    EXPECT_EQ(read.options, before.options) << what << "\n" << lines;
    EXPECT_EQ(read.timeout, before.timeout) << what;
    EXPECT_EQ(read.memory, before.memory) << what;
    const Shot after = parsed(reproduceCommand(read));
    EXPECT_EQ(after.options, before.options) << what << "\n" << reproduceCommand(read);
    EXPECT_EQ(after.timeout, before.timeout) << what;
    EXPECT_EQ(after.memory, before.memory) << what;
    EXPECT_EQ(optionLines(after, folder.path()), lines) << what;
}

TEST(OptionTable, EveryOptionSurvivesSuiteAndCommandLine) {
    for (const OptionRow& row : optionTable()) {
        Shot shot;
        test::setSample(row, shot);
        EXPECT_FALSE(isDefault(row, shot)) << row.name << row.key;
        if (const OptionRow* needed = findOption(row.needs)) test::setSample(*needed, shot);
        expectSurvives(shot, std::string(row.name) + " " + std::string(row.key));
    }
}

TEST(OptionTable, AllOptionsTogetherSurviveSuiteAndCommandLine) {
    Shot shot;
    for (const OptionRow& row : optionTable()) test::setSample(row, shot);
    expectSurvives(shot, "all");
}

TEST(OptionTable, ADefaultIsNotWritten) {
    EXPECT_EQ(optionArguments(Shot{}), "");
    EXPECT_EQ(optionLines(Shot{}, "."), "");
    Shot counts;  // without effect: render refuses it without --max-error
    counts.options.overrideCounts = true;
    EXPECT_EQ(optionArguments(counts), "");
}

TEST(OptionTable, NamesAndKeysAreUniqueAndDescribed) {
    std::set<std::string_view> names, keys;
    for (const OptionRow& row : optionTable()) {
        EXPECT_FALSE(row.name.empty() && row.key.empty());
        EXPECT_FALSE(row.help.empty()) << row.name;
        EXPECT_TRUE(row.name.empty() || names.insert(row.name).second) << row.name;
        EXPECT_TRUE(row.key.empty() || keys.insert(row.key).second) << row.key;
        EXPECT_TRUE(row.needs.empty() || findOption(row.needs)) << row.name;
    }
}

TEST(OptionTable, ANameThatOurSourcesGiveWithoutARowIsReported) {
    EXPECT_EQ(optionNamed("size").name, "size");
    EXPECT_EQ(optionNamed("view").name, "eye") << "its former name";
    EXPECT_THROW((void)optionNamed("colour"), std::logic_error);
}

TEST(OptionTable, ThePageOfSuitesHasEveryKeyAndNoOther) {
    std::ifstream file(GLIBRA_SOURCE_DIR "/docs/suites.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    const std::size_t table = page.find("## Keys of a shot");
    ASSERT_NE(table, std::string::npos);
    const std::string keys = page.substr(table, page.find("\n## ", table) - table);
    static const std::regex kFirstCell("\n\\| (`[^|]*`) \\|"), kKey("`([a-z-]+)`");
    const test::SceneFolder folder({"a.glib"});
    for (std::sregex_iterator row(keys.begin(), keys.end(), kFirstCell), end; row != end; ++row) {
        const std::string cell = (*row)[1];
        for (std::sregex_iterator key(cell.begin(), cell.end(), kKey); key != end; ++key)
            EXPECT_EQ(
                folder.show("[[shot]]\nscript = 'a.glib'\n" + (*key)[1].str() + " = 0\n").find("suite-E02"),
                std::string::npos)
                << (*key)[1] << ": the table under 'Keys of a shot' in docs/suites.md has a key that is none";
    }
    for (const OptionRow& row : optionTable())
        EXPECT_TRUE(row.key.empty() || keys.find(fmt::format("`{}`", row.key)) != std::string::npos)
            << row.key << ": add it to the table under 'Keys of a shot' in docs/suites.md";
}

TEST(OptionTable, AWrongTextSaysWhatWouldBeRightAndChangesNothing) {
    const struct {
        const char *name, *text, *message;
    } kCases[] = {
        {"samples", "many", "expected a whole number from 1 to 64, found 'many'"},
        {"samples", "65", "expected a whole number from 1 to 64, found '65'"},
        {"samples", "4x", "expected a whole number from 1 to 64, found '4x'"},
        {"size", "800", "expected WxH with 1 to 65536 pixels a side, as 800x600, found '800'"},
        {"size", "0x10", "expected WxH with 1 to 65536 pixels a side, as 800x600, found '0x10'"},
        {"view", "best", "expected auto or glman, found 'best'"},
        {"background", "1,2", "expected R,G,B or R,G,B,A, as 0,.5,1, found '1,2'"},
        {"background", "0,3.5e38,1", "expected R,G,B or R,G,B,A, as 0,.5,1, found '0,3.5e38,1'"},
        {"eye-transform", "1,2", "expected 16 numbers separated by commas, column by column, found '1,2'"},
        {"object-transform", "0:1",
         "expected LINE:M, the line of the object in the scene and a matrix, found '0:1'"},
        {"time", "nan", "expected a number from -1e+09 to 1e+09, found 'nan'"},
        {"library", "", "expected a folder, found ''"},
    };
    for (const auto& each : kCases) {
        Shot shot;
        EXPECT_EQ(readOptionText(*findOption(each.name), each.text, shot), each.message);
        EXPECT_EQ(shot.options, RenderOptions{}) << each.name;
    }
}

}  // namespace
}  // namespace glibra::suite
