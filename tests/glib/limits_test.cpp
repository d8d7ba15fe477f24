// Limits of the text (language, 11), and the number of messages that are kept (language, 10).

#include <gtest/gtest.h>

#include <string>

#include "glib/limits.h"
#include "scene.h"

namespace glibra::glib::test {
namespace {

std::string repeated(std::string_view piece, std::size_t count) {
    std::string text;
    text.reserve(piece.size() * count);
    for (std::size_t i = 0; i < count; ++i) text += piece;
    return text;
}

TEST(Limits, FileOf4MiB) {
    EXPECT_TRUE(idsOf(std::string(kLargestFile, '\n')).empty());
    EXPECT_EQ(idsOf(std::string(kLargestFile + 1, '\n')), Ids{"glib-E15"});
}

TEST(Limits, LineOf64KiB) {
    EXPECT_TRUE(idsOf("Teapot #" + std::string(kLongestLine - 8, 'x')).empty());
    EXPECT_EQ(idsOf("Teapot #" + std::string(kLongestLine - 7, 'x') + "\nBox"), Ids{"glib-E15"});
    EXPECT_EQ(wordsOf("Teapot #" + std::string(kLongestLine - 7, 'x') + "\nBox"),
              std::vector<std::string>{"Box"});
}

TEST(Limits, Statements) {
    const std::string most = repeated("Box\n", kMostStatements);
    EXPECT_EQ(read(most).commands.size(), kMostStatements);
    EXPECT_TRUE(idsOf(most).empty());
    EXPECT_EQ(idsOf(most + "Box\nBox\n"), Ids{"glib-E15"});
}

TEST(Limits, Programs) {
    EXPECT_TRUE(idsOf(repeated("Program P\n", kMostPrograms)).empty());
    EXPECT_EQ(idsOf(repeated("Program P\n", kMostPrograms + 1)), Ids{"glib-E15"});
}

TEST(Limits, TagsOfAProgram) {
    std::string text = "Program P";
    for (std::size_t i = 0; i < kMostTags; ++i) text += " \\\n u" + std::to_string(i) + " 1";
    EXPECT_EQ(read(text).commands.at(0).uniforms.size(), kMostTags);
    EXPECT_TRUE(idsOf(text).empty());
    EXPECT_EQ(idsOf(text + " uMore 1"), Ids{"glib-E15"});
}

TEST(Limits, ValuesOfABracket) {
    EXPECT_TRUE(idsOf("Program P u [" + repeated("1 ", kMostBracketValues) + "]").empty());
    EXPECT_EQ(idsOf("Program P u [" + repeated("1 ", kMostBracketValues + 1) + "]"), Ids{"glib-E15"});
}

TEST(Messages, AreKeptUpToAHundredAndThenCounted) {
    const Script script = read(repeated("Spere\n", 250));
    ASSERT_EQ(script.diagnostics.size(), 101U);
    EXPECT_EQ(script.diagnostics.back().severity, Severity::note);
    EXPECT_EQ(script.diagnostics.back().text, "150 more messages not shown, 150 errors of them");
}

TEST(Messages, ErrorAfterManyWarningsIsNotLost) {
    const Script script = read(repeated("Color 2 0 0\n", 150) + "Spere\n");
    ASSERT_EQ(script.diagnostics.size(), 101U);
    EXPECT_TRUE(hasError(script.diagnostics));
    EXPECT_EQ(script.diagnostics[99].id, "glib-E01");
    EXPECT_EQ(script.diagnostics.back().text, "51 more messages not shown");
}

TEST(Messages, ExactlyAHundredNeedNoCount) {
    EXPECT_EQ(read(repeated("Spere\n", 100)).diagnostics.size(), 100U);
}

TEST(Messages, StandInTheOrderOfTheirPlaces) {
    const Script script = read("Color 1, 2 0 0 0\nSphere 1 \\\n\nSpere\nColor 5 0 0");
    for (std::size_t i = 1; i < script.diagnostics.size(); ++i) {
        const Place& before = script.diagnostics[i - 1].place;
        const Place& here = script.diagnostics[i].place;
        EXPECT_TRUE(before.line < here.line || (before.line == here.line && before.column <= here.column));
    }
    EXPECT_EQ(script.diagnostics.at(0).place.file, "scene.glib");
}

TEST(Messages, LongWordsAreCut) {
    const std::string text = messageOf(std::string(5000, 'x'), "glib-E01");
    EXPECT_LT(text.size(), 100U);
}

}  // namespace
}  // namespace glibra::glib::test
