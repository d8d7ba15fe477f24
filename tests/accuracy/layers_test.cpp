#include <gtest/gtest.h>

#include "bench/core/figure.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Layers = FiguresOf<measureLayers>;

TEST_F(Layers, AreSound) {
    expectSound(figures);
}

TEST_F(Layers, BytesLoseWhatLayersAddAndFloatsDoNot) {
    EXPECT_GT(curve("blending", "8 bit").points.back().error, 1);
    EXPECT_LT(curve("blending", "16 bit").points.back().error, .5);
    EXPECT_LT(curve("blending", "float").points.back().error, .001);
}

TEST_F(Layers, HalfFloatsLoseMoreOfASumThanFloats) {
    for (const char* way : {"sum of shares, ", "running mean, "}) {
        const Curve& half = curve("accumulation", way + std::string("half float"));
        EXPECT_GT(half.points.back().error, .02) << way;
        EXPECT_GT(half.points.back().error, half.points.front().error) << way;
        EXPECT_LT(curve("accumulation", way + std::string("float")).points.back().error, .01) << way;
    }
    for (const Figure& each : figures)
        EXPECT_NE(each.findings.back().find("half floats"), std::string::npos) << each.findings.back();
}

}  // namespace
}  // namespace glibra::bench::test
