#include "view/edit/source_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace glibra::test {
namespace {

std::string toggled(std::string text, std::string_view marker) {
    const std::size_t begin = text.find('[');
    text.erase(begin, 1);
    const std::size_t end = text.find(']');
    text.erase(end, 1);
    view::EditedText result = view::toggledComments(text, {begin, end}, marker);
    result.text.insert(result.selection.end, "]");
    result.text.insert(result.selection.begin, "[");
    return result.text;
}

TEST(CommentLines, CommentsTheSelectedLinesInOneColumn) {
    EXPECT_EQ(toggled("a\n  [b\n    c\n\n  d]\ne", "//"), "a\n  [// b\n  //   c\n\n  // d]\ne");
    EXPECT_EQ(toggled("[a\nb\n]c", "#"), "[# a\n# b\n]c") << "a line without selected letters does not count";
}

TEST(CommentLines, MakesCodeOfComments) {
    EXPECT_EQ(toggled("[// a\n  //b\n\n// c]", "//"), "[a\n  b\n\nc]");
    EXPECT_EQ(toggled("[// a\nb]", "//"), "[// // a\n// b]") << "not all of them are comments";
}

TEST(CommentLines, KeepsTheCursorAtItsLetter) {
    EXPECT_EQ(toggled("ab[]c\n", "//"), "// ab[]c\n");
    EXPECT_EQ(toggled("// ab[]c\n", "//"), "ab[]c\n");
    EXPECT_EQ(toggled("[]abc", "#"), "# []abc");
    EXPECT_EQ(toggled("/[]/ abc", "//"), "[]abc");
    EXPECT_EQ(toggled("[]", "//"), "[]");
    EXPECT_EQ(toggled("a\n[]\nb", "//"), "a\n[]\nb");
}

TEST(CommentLines, IsItsOwnInverse) {
    const std::string text = "void main() {\n    int a;\n\tint b;\n}\n";
    const view::EditedText once = view::toggledComments(text, {0, text.size()}, "//");
    EXPECT_NE(once.text, text);
    EXPECT_EQ(view::toggledComments(once.text, once.selection, "//").text, text);
}

std::string indented(std::string text, bool back) {
    const std::size_t begin = text.find('[');
    text.erase(begin, 1);
    const std::size_t end = text.find(']');
    text.erase(end, 1);
    view::EditedText result = view::indentedLines(text, {begin, end}, back);
    result.text.insert(result.selection.end, "]");
    result.text.insert(result.selection.begin, "[");
    return result.text;
}

TEST(IndentedLines, MoveByFourBlanksAndKeepEveryLetter) {
    EXPECT_EQ(indented("[one\ntwo\n]three\n", false), "[    one\n    two\n]three\n");
    EXPECT_EQ(indented("a [part] of a line\n", false), "    a [part] of a line\n");
    EXPECT_EQ(indented("[one\n\n  two]", false), "[    one\n\n      two]") << "blank lines stay";
}

TEST(IndentedLines, MoveBackAsFarAsThereAreBlanks) {
    EXPECT_EQ(indented("[    one\n  two\n\tthree\nfour]", true), "[one\ntwo\nthree\nfour]");
    EXPECT_EQ(indented("        o[]ne", true), "    o[]ne");
    EXPECT_EQ(indented("on[]e", true), "on[]e");
    EXPECT_EQ(indented("  []", true), "[]");
}

TEST(IndentedLines, WithoutASelectionBlanksLeadToTheNextColumn) {
    EXPECT_EQ(indented("[]one", false), "    []one");
    EXPECT_EQ(indented("x\nab[]c", false), "x\nab  []c");
    EXPECT_EQ(indented("[]", false), "    []");
}

}  // namespace
}  // namespace glibra::test
