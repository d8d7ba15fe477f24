#include <gtest/gtest.h>

#include <cmath>

#include "bench/subjects/scene_pictures.h"

namespace glibra::bench {
namespace {

/// A disk with the given centre and radius and hard edges, on smooth stripes.
image::Image disk(double x, double y, double radius) {
    image::Image picture{96, 80, 3, image::Component::u8, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            const bool isInside = std::hypot(column + .5 - x, row + .5 - y) < radius;
            const int ground = column;
            for (int i = 0; i < 3; ++i)
                picture.data.push_back(static_cast<std::byte>(isInside ? 250 : ground));
        }
    return picture;
}

TEST(Displacement, OfEqualPicturesIsZero) {
    EXPECT_EQ(displacement(disk(40, 40, 20), disk(40, 40, 20), 5), 0);
}

TEST(Displacement, IsHowFarAnEdgeMoves) {
    for (const int moved : {1, 2, 4}) {
        EXPECT_EQ(displacement(disk(40, 40, 20), disk(40 + moved, 40, 20), 8), moved);
        EXPECT_EQ(displacement(disk(40, 40, 20), disk(40, 40 - moved, 20), 8), moved);
        EXPECT_EQ(displacement(disk(40, 40, 20), disk(40, 40, 20 + moved), 8), moved);
    }
}

TEST(Displacement, OfAMissingShapeExceedsEveryRadius) {
    EXPECT_EQ(displacement(disk(40, 40, 20), disk(40, 40, 0), 8), 9);
    EXPECT_EQ(displacement(disk(40, 40, 0), disk(40, 40, 20), 8), 9);
}

}  // namespace
}  // namespace glibra::bench
