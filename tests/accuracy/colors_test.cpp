#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bench/core/figure.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Colors = FiguresOf<measureColors>;

TEST_F(Colors, AreSound) {
    expectSound(figures);
}

TEST_F(Colors, LinearLightInBytesLosesDarkTonesAndMoreBitsKeepThem) {
    EXPECT_GT(curve("round-trips", "the curve of sRGB, 8 bit").points.front().error, 5);
    EXPECT_LT(curve("round-trips", "the curve of sRGB, 16 bit").points.front().error, .5);
    EXPECT_LT(curve("round-trips", "the curve of sRGB, float").points.back().error, .01);
}

TEST_F(Colors, FindingsAreAboutTheLastRoundTrip) {
    const Point& last = curve("round-trips", "the curve of sRGB, 8 bit").points.back();
    EXPECT_EQ(curve("round-trips", "the curve of sRGB, 8 bit").points.front().label, "1 round trip");
    const std::vector<std::string>& findings = figure("round-trips").findings;
    EXPECT_TRUE(findings.front().ends_with(numberText(last.error) + " after " + last.label))
        << findings.front();
    EXPECT_NE(findings.back().find("half floats"), std::string::npos) << findings.back();
}

TEST_F(Colors, AWayBackByAnotherCurveIsWrongWhateverTheTexels) {
    EXPECT_GT(curve("round-trips", "decoded by the curve, encoded by power 2.2, float").points.front().error,
              1);
}

}  // namespace
}  // namespace glibra::bench::test
