// Long lines in rows: where they are broken, and what an edit of the rows makes of the text.

#include "view/edit/source_lines.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace glibra::test {
namespace {

using view::EditedRows;
using view::WrappedText;

/// A character is one wide, a tab four.
WrappedText inRows(std::string_view text, float room) {
    return {text, view::breaksOf(text, room, 1,
                                 [](std::string_view character) { return character == "\t" ? 4.F : 1.F; })};
}

TEST(WrappedText, BreaksBehindBlanksAndInsideOfWordsThatAreTooLong) {
    EXPECT_EQ(inRows("one two three", 8).rows, "one two \nthree");
    EXPECT_EQ(inRows("one two three", 7).rows, "one two \nthree") << "the blank stands in the margin";
    EXPECT_EQ(inRows("one two three", 6).rows, "one \ntwo \nthree");
    EXPECT_EQ(inRows("one two three", 3).rows, "one \ntwo \nthr\nee");
    EXPECT_EQ(inRows("one two three", 13).rows, "one two three");
    EXPECT_EQ(inRows("ab\n\nabcdef\nx", 4).rows, "ab\n\nabcd\nef\nx");
    EXPECT_EQ(inRows("\tab", 5).rows, "\t\nab");
    EXPECT_EQ(inRows("\u00e4\u00f6\u00fc\u00df", 2).rows, "\u00e4\u00f6\n\u00fc\u00df");
    EXPECT_EQ(inRows("", 4).rows, "");
}

TEST(WrappedText, EveryPlaceOfTheTextHasOneInTheRows) {
    const std::string text = "float f = one + two;\n\tc = vec4(f);\n\nlonglonglonglong\n";
    for (const float room : {3.F, 5.F, 8.F, 40.F}) {
        const WrappedText wrapped = inRows(text, room);
        for (std::size_t at = 0; at <= text.size(); ++at) {
            EXPECT_EQ(wrapped.placeInText(wrapped.placeInRows(at)), at);
            if (at < text.size()) {
                EXPECT_EQ(wrapped.rows[wrapped.placeInRows(at)], text[at]);
            }
        }
        std::string joined;
        for (std::size_t at = 0; at < wrapped.rows.size(); ++at)
            if (wrapped.placeInText(at) != wrapped.placeInText(at + 1)) joined += wrapped.rows[at];
        EXPECT_EQ(joined, text);
    }
}

/// The text after rows [begin, end) were replaced, as if by keys with the cursor there before.
std::string edited(const WrappedText& before, std::size_t begin, std::size_t end, std::string_view by,
                   std::size_t cursor) {
    std::string now = before.rows;
    now.replace(begin, end - begin, by);
    const EditedRows result(before, now, cursor, begin + by.size(), end > begin + 1);
    EXPECT_LE(result.placeInText(begin + by.size()), result.text().size());
    return result.text();
}

TEST(WrappedText, AnEditOfTheRowsIsOneOfTheText) {
    const WrappedText wrapped = inRows("one two three", 8);  // "one two |three"
    EXPECT_EQ(edited(wrapped, 8, 8, "X", 8), "one two Xthree") << "before the break";
    EXPECT_EQ(edited(wrapped, 9, 9, "X", 9), "one two Xthree") << "after it";
    EXPECT_EQ(edited(wrapped, 9, 9, "\n", 9), "one two \nthree");
    EXPECT_EQ(EditedRows(wrapped, "one two \n\nthree", 8, 9, false).placeInText(9), 9U)
        << "Enter before the break";
    EXPECT_EQ(edited(wrapped, 4, 11, "", 4), "one ree") << "a selection over the break";
    EXPECT_EQ(edited(inRows("abcd", 2), 1, 3, "\n", 3), "a\ncd") << "Enter over the end of a row";
    EXPECT_EQ(edited(wrapped, 8, 9, "", 9), "one twothree") << "Backspace at the beginning of a row";
    EXPECT_EQ(edited(wrapped, 8, 9, "", 8), "one two hree") << "Delete at the end of a row";
    EXPECT_EQ(edited(inRows("\u00e4\u00f6\u00fc\u00df", 2), 4, 5, "", 5), "\u00e4\u00fc\u00df");
}

TEST(WrappedText, RandomEditsAreThoseOfThePlainText) {
    unsigned state = 1;
    const auto random = [&](std::size_t below) {
        state = state * 1664525U + 1013904223U;
        return static_cast<std::size_t>(state >> 8U) % below;
    };
    std::string text = "vec3 colour = mix(low, high, t);\n    f = colour * 2.;\n";
    for (int i = 0; i < 3000; ++i) {
        const WrappedText wrapped = inRows(text, static_cast<float>(3 + random(12)));
        const std::size_t begin = random(text.size() + 1);
        const std::size_t end = std::min(text.size(), begin + (random(3) == 0 ? random(6) : 0));
        const std::string added(random(4), "ab \n"[random(4)]);
        std::string expected = text, now = wrapped.rows;
        expected.replace(begin, end - begin, added);
        const std::size_t from = wrapped.placeInRows(begin), to = wrapped.placeInRows(end);
        now.replace(from, to - from, added);
        const EditedRows result(wrapped, now, to, from + added.size(), begin < end);
        ASSERT_EQ(result.text(), expected) << i;
        ASSERT_EQ(result.placeInText(from + added.size()), begin + added.size()) << i;
        text = expected.size() < 200 ? expected : expected.substr(0, 60);
    }
}

}  // namespace
}  // namespace glibra::test
