// Subjects that are settings of a scene.

#include <gtest/gtest.h>

#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(NearFar, PlanesFightWhereTheStepOfTheDepthIsTheirGap) {
    const std::vector<Figure> figures = quickFigures(measureNearFar);
    expectSound(figures);
    // A step of 24 bits 100 units away is z^2 / (2^24 near): 6e-4 units at near = 1, .6 at near = .001.
    const Curve& curve = curveOf(figures.front(), "gap of 0.1 units");
    for (const Point& each : curve.points) {
        if (each.setting <= 1e4) {
            EXPECT_EQ(each.error, 0) << each.label;
        } else if (each.setting >= 1e6) {
            EXPECT_GT(each.error, .01) << each.label;
        }
    }
}

TEST(Shadows, ComeCloserToTheFinestWithTheResolution) {
    const std::vector<Figure> figures = quickFigures(measureShadows);
    ASSERT_EQ(figures.size(), 3U);
    const std::vector<Point>& points = figures.front().curves.front().points;
    EXPECT_GT(points[0].error, 1.5 * points[1].error);
    EXPECT_EQ(points.back().error, 0);
}

}  // namespace
}  // namespace glibra::bench::test
