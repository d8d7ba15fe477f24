// Subjects that are settings of a scene.

#include <gtest/gtest.h>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

TEST(NearFar, PlanesFightWhereTheStepOfTheDepthIsTheirGap) {
    const std::vector<Figure> figures = quickFigures(measureNearFar);
    expectSound(figures);
    // A step of 24 bits 100 units away is z^2 / (2^24 near): 6e-4 units at near = 1, .6 at near = .001.
    struct Limit {
        const char* curve;
        double right;         ///< no pixel is wrong up to this far / near
        double wrong, share;  ///< at this far / near, more than that share is wrong
    };
    for (const Limit& limit : {Limit{"gap of 1 units", 1e5, 1e7, .01},
                               {"gap of 0.1 units", 1e4, 1e6, .1},
                               {"gap of 0.01 units", 1e3, 1e5, .01}})
        for (const Point& each : curveOf(figures.front(), limit.curve).points) {
            if (each.setting <= limit.right) {
                EXPECT_EQ(each.error, 0) << limit.curve << ", " << each.label;
            } else if (each.setting == limit.wrong) {
                EXPECT_GT(each.error, limit.share) << limit.curve << ", " << each.label;
            }
        }
}

TEST(Shadows, ComeCloserToTheFinestWithTheResolutionAndOnlyWithTheOffset) {
    const std::vector<Figure> figures = quickFigures(measureShadows);
    expectSound(figures);
    ASSERT_EQ(figures.size(), 1U);
    const std::vector<Curve>& curves = figures.front().curves;
    ASSERT_EQ(curves.size(), 3U);
    const std::vector<Point>& own = curves[0].points;
    EXPECT_GT(own[0].error, 1.5 * own[1].error);
    // Neither stripes nor detached shadows go away with more texels.
    EXPECT_GT(curves[1].points.back().error, 4 * own[0].error);
    EXPECT_GT(curves[2].points.back().error, 2 * own[0].error);
}

TEST(Sweep, ReportsAMessageOnceAndComparesWithAGivenPicture) {
    Bench bench({.quick = true});
    SceneSweep sweep;
    sweep.scene = "s.glib";
    sweep.name = "grey";
    sweep.values = {.25, .5};
    sweep.options.samples = 1;
    sweep.options.sceneText =
        "WindowSize 8 8\nLet grey <0. .5 1.>\nBackground (grey) (grey) (grey)\nPushMatrix\n";
    const std::vector<Figure> own = measureSweep(bench, sweep);
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].curves[0].points[1].error, 0);
    EXPECT_EQ(bench.problems().size(), 1U);  // that PopMatrix is missing

    RenderOptions options = sweep.options;
    options.set = {"grey=1"};
    const image::Image white = need(scenePicture(bench.context(), sweep.scene, options));
    sweep.reference = &white;
    const Curve& curve = measureSweep(bench, sweep).front().curves.front();
    EXPECT_NEAR(curve.points[0].error, .75 * 255, .6);
    EXPECT_NEAR(curve.points[1].error, .5 * 255, .6);
}

}  // namespace
}  // namespace glibra::bench::test
