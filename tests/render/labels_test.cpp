#include "render/draw/axes.h"

#include <gtest/gtest.h>

namespace glibra::test {
namespace {

std::vector<std::string> lines(int count) {
    std::vector<std::string> all;
    for (int i = 0; i < count; ++i) all.push_back("P : u = " + std::to_string(i));
    return all;
}

TEST(LabelBlock, LiesInItsCorner) {
    const auto block = [](LabelCorner corner) { return render::labelBlock(400, 300, lines(3), corner); };
    const render::LabelBlock bottomLeft = block(LabelCorner::bottomLeft);
    EXPECT_EQ(bottomLeft.left, 4);
    EXPECT_EQ(bottomLeft.top + bottomLeft.height, 296);
    EXPECT_EQ(bottomLeft.height, 3 * 16);
    const render::LabelBlock topRight = block(LabelCorner::topRight);
    EXPECT_EQ(topRight.top, 4);
    EXPECT_EQ(topRight.left + topRight.width, 396);
    EXPECT_EQ(block(LabelCorner::bottomRight).left, topRight.left);
    EXPECT_EQ(block(LabelCorner::topLeft).top, 4);
}

TEST(LabelBlock, GrowsWithThePicture) {
    const auto scale = [](int height) {
        return render::labelBlock(9999, height, lines(1), LabelCorner::bottomLeft).scale;
    };
    EXPECT_EQ(scale(100), 1);
    EXPECT_EQ(scale(600), 1);
    EXPECT_EQ(scale(768), 1);
    EXPECT_EQ(scale(1080), 2);
    EXPECT_EQ(scale(2160), 3);
}

TEST(LabelBlock, SaysHowManyLinesAreLeftOut) {
    const render::LabelBlock block = render::labelBlock(300, 100, lines(9), LabelCorner::bottomLeft);
    ASSERT_EQ(block.lines.size(), 5U);
    EXPECT_EQ(block.lines[3], "P : u = 3");
    EXPECT_EQ(block.lines[4], "... and 5 more");
    EXPECT_TRUE(render::labelBlock(300, 10, lines(9), LabelCorner::bottomLeft).lines.empty());
}

}  // namespace
}  // namespace glibra::test
