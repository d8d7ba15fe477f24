#include "view/edit/source_lines.h"

#include <gtest/gtest.h>

#include <string>

namespace glibra::test {
namespace {

using view::movedLine;

TEST(MovedLine, IsFoundByItsWords) {
    const std::string text = "Color 1 0 0\nSphere 1\nColor 0 1 0\nBox 1\n";
    EXPECT_EQ(movedLine(text, text, 2), 2);
    EXPECT_EQ(movedLine(text, "# new\n" + text, 2), 3);
    EXPECT_EQ(movedLine(text, text + "Sphere 1\n", 4), 4);
    EXPECT_EQ(movedLine(text, "Color 1 0 0\n    Sphere 1   \nBox 1\n", 2), 2) << "blanks do not count";
    EXPECT_EQ(movedLine(text, "Sphere 1\nColor 1 0 0\n\nColor 0 1 0\nBox 1", 4), 5);
    EXPECT_EQ(movedLine(text, "Color 1 0 0\r\nSphere 1\r\nBox 1\r\n", 4), 3);
}

TEST(MovedLine, IsFoundBetweenItsNeighboursIfItWasEdited) {
    const std::string text = "Color 1 0 0\nSphere 1\nColor 0 1 0\nSphere 2\n";
    EXPECT_EQ(movedLine(text, "Color 1 0 0\nSphere 1.5\nColor 0 1 0\nSphere 2\n", 2), 2);
    EXPECT_EQ(movedLine(text, "Color 1 0 0\n\nSphere 1.5\nColor 0 1 0\nSphere 2\n", 2), 3);
    EXPECT_EQ(movedLine(text, "Color 0 0 0\nSphere 3\nColor 0 0 1\nSphere 4\n", 4), 4)
        << "all lines are others";
}

TEST(MovedLine, IsGoneIfNothingTookItsPlace) {
    const std::string text = "Color 1 0 0\nSphere 1\nColor 0 1 0\nSphere 2\n";
    EXPECT_EQ(movedLine(text, "Color 1 0 0\nColor 0 1 0\nSphere 2\n", 2), 0);
    EXPECT_EQ(movedLine(text, "Color 0 1 0\nSphere 2\n", 2), 0) << "Sphere 2 is another one";
    EXPECT_EQ(movedLine(text, "Color 1 0 0\nSpher\nColor 0 1 0\nSphere 2\n", 2), 0);
    EXPECT_EQ(movedLine(text, "", 2), 0);
    EXPECT_EQ(movedLine(text, text, 0), 0);
    EXPECT_EQ(movedLine(text, text, 6), 0);
}

TEST(MovedLine, OfLargeTextsIsFoundToo) {
    std::string before, after;
    for (int i = 0; i < 5000; ++i) {
        before += "Sphere " + std::to_string(i) + "\n";
        after += "Sphere " + std::to_string(i + 5000) + "\n";
    }
    EXPECT_EQ(movedLine(before, "# new\n" + before, 4000), 4001);
    EXPECT_EQ(movedLine(before, after, 4000), 4000) << "by its order, as every line is another one";
}

}  // namespace
}  // namespace glibra::test
