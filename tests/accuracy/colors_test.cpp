#include <gtest/gtest.h>

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

TEST_F(Colors, AWayBackByAnotherCurveIsWrongWhateverTheTexels) {
    EXPECT_GT(curve("round-trips", "decoded by the curve, encoded by power 2.2, float").points.front().error,
              1);
}

}  // namespace
}  // namespace glibra::bench::test
