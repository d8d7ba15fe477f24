#include "render/draw/expanded_geometry.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace glibra::render {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Strips that begin at these vertices.
EmittedStrips strips(std::initializer_list<std::uint32_t> begins, std::uint32_t vertices) {
    EmittedStrips made;
    for (const std::uint32_t each : begins) made.begins.at(each / 32) |= 1U << each % 32;
    made.vertices = vertices;
    return made;
}

TEST(EmittedStrips, EverySecondTriangleHasItsFirstTwoCornersInTheOtherOrder) {
    EXPECT_EQ(indicesOf(strips({0}, 5), 3), (Indices{0, 1, 2, 2, 1, 3, 2, 3, 4}));
}

TEST(EmittedStrips, EachStripBeginsAnew) {
    EXPECT_EQ(indicesOf(strips({0, 3}, 7), 3), (Indices{0, 1, 2, 3, 4, 5, 5, 4, 6}));
    EXPECT_EQ(indicesOf(strips({0, 2, 40}, 43), 2).size(), 2U * (1 + 37 + 2));
    EXPECT_EQ(indicesOf(strips({0, 2, 5}, 6), 3), (Indices{2, 3, 4}))
        << "strips that are too short draw nothing";
}

TEST(EmittedStrips, LinesAndPointsAreInTheOrderOfTheirVertices) {
    EXPECT_EQ(indicesOf(strips({0}, 3), 2), (Indices{0, 1, 1, 2}));
    EXPECT_EQ(indicesOf(strips({0, 1, 2}, 3), 1), (Indices{0, 1, 2}));
    EXPECT_TRUE(indicesOf({}, 3).empty());
}

}  // namespace
}  // namespace glibra::render
