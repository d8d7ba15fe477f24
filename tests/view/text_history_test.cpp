#include "view/edit/edited_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace glibra::test {
namespace {

using view::TextHistory;

/// Types the letters at the end of the text, one by one. Returns the new text.
std::string typed(TextHistory& history, std::string text, std::string_view letters) {
    for (const char each : letters) {
        text += each;
        history.record(text);
    }
    return text;
}

TEST(TextHistory, AWordIsAStep) {
    TextHistory history("int a;\n");
    EXPECT_FALSE(history.canUndo());
    typed(history, "int a;\n", "one two");
    EXPECT_EQ(history.undo().text, "int a;\none ");
    EXPECT_EQ(history.undo().text, "int a;\n");
    EXPECT_FALSE(history.canUndo());
    EXPECT_EQ(history.redo().text, "int a;\none ");
    const TextHistory::State again = history.redo();
    EXPECT_EQ(again.text, "int a;\none two");
    EXPECT_EQ(again.cursor, again.text.size());
    EXPECT_FALSE(history.canRedo());
}

TEST(TextHistory, ALineIsAStep) {
    TextHistory history("");
    typed(history, "", "a\nb");
    EXPECT_EQ(history.undo().text, "a\n");
    EXPECT_EQ(history.undo().text, "a");
}

TEST(TextHistory, LettersDeletedOneAfterTheOtherAreAStep) {
    TextHistory history("abcdef");
    for (const char* each : {"abcde", "abcd", "abc"}) history.record(each);
    const TextHistory::State before = history.undo();
    EXPECT_EQ(before.text, "abcdef");
    EXPECT_EQ(before.cursor, 6U);
    // The same with deletions in front of the cursor.
    for (const char* each : {"bcdef", "cdef"}) history.record(each);
    EXPECT_EQ(history.undo().text, "abcdef");
}

TEST(TextHistory, AStepEndsWhereTheCursorLeaves) {
    TextHistory history("");
    const std::string text = typed(history, "", "ab");
    history.endStep();
    typed(history, text, "cd");
    EXPECT_EQ(history.undo().text, "ab");
}

TEST(TextHistory, WhatIsTypedAfterUndoTakesThePlaceOfWhatWasUndone) {
    TextHistory history("");
    typed(history, "", "one");
    history.undo();
    typed(history, "", "two");
    EXPECT_FALSE(history.canRedo());
    EXPECT_EQ(history.undo().text, "");
    EXPECT_EQ(history.redo().text, "two");
}

TEST(TextHistory, NoCharacterIsCut) {
    // ä is C3 A4, ö is C3 B6: their first bytes are the same.
    TextHistory history("\xC3\xA4");
    history.record("\xC3\xB6");
    const TextHistory::State before = history.undo();
    EXPECT_EQ(before.text, "\xC3\xA4");
    EXPECT_EQ(before.cursor, 2U);
}

TEST(TextHistory, LeadsBackThroughAnyChanges) {
    std::mt19937 random(1);
    std::vector<std::string> texts{"uniform float uKd;\n"};
    TextHistory history(texts.front());
    for (int i = 0; i < 500; ++i) {
        std::string text = texts.back();
        const std::size_t at = random() % (text.size() + 1);
        const std::size_t gone = std::min<std::size_t>(text.size() - at, random() % 4);
        text.replace(at, gone, std::string(random() % 4, static_cast<char>('a' + random() % 3)));
        history.record(text);
        history.endStep();
        if (text != texts.back()) texts.push_back(text);
    }
    for (std::size_t i = texts.size() - 1; i-- > 0;) ASSERT_EQ(history.undo().text, texts[i]) << i;
    EXPECT_FALSE(history.canUndo());
    for (std::size_t i = 1; i < texts.size(); ++i) ASSERT_EQ(history.redo().text, texts[i]) << i;
    EXPECT_FALSE(history.canRedo());
}

}  // namespace
}  // namespace glibra::test
