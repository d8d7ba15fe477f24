// --max-error on scenes of the library with Bound.

#include <gtest/gtest.h>

#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(MeasuredBounds, AreKeptByEveryScene) {
    const std::vector<Figure> figures = quickFigures(measureBounds);
    expectSound(figures);
    const Figure& figure = figureOf(figures, "bound-1");
    ASSERT_EQ(figure.curves[0].points.size(), 3U);
    for (const Point& each : figure.curves[0].points) EXPECT_LE(each.error, 1) << each.label;
    for (const Point& each : figure.curves[2].points) EXPECT_EQ(each.error, 0) << each.label;
}

}  // namespace
}  // namespace glibra::bench::test
