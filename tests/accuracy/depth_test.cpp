#include <gtest/gtest.h>

#include <cmath>

#include "bench/core/figure.h"
#include "bench/reference/exact.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Depth = FiguresOf<measureDepth>;

/// The depth as stored in a buffer with `bits` bits.
double kept(double z, double near, double far, int bits) {
    const double depth = far * (z - near) / (z * (far - near));
    return std::round(depth * (std::ldexp(1., bits) - 1));
}

TEST_F(Depth, OneStepInTheoryIsWhereTheRoundedDepthChangesForSure) {
    for (const DepthKind& kind : kDepthKinds) {
        if (kind.isFloat()) continue;
        for (const double z : {1.5, 20., 700., 5000.}) {
            const double gap = depthStep(kind, 1, 1e4, z);
            if (std::isnan(gap)) continue;
            EXPECT_NE(kept(z, 1, 1e4, kind.bits), kept(z + 1.001 * gap, 1, 1e4, kind.bits));
            int same = 0;
            for (int phase = 0; phase < 16; ++phase) {
                const double there = z + gap * phase / 16;
                if (kept(there, 1, 1e4, kind.bits) == kept(there + .45 * gap, 1, 1e4, kind.bits)) ++same;
            }
            EXPECT_GT(same, 0) << kind.name << " at " << z;
        }
    }
}

TEST_F(Depth, EveryKindResolvesGapsAsInTheory) {
    for (const char* name : {"gap-by-range", "gap-by-distance"})
        for (const Curve& measured : figure(name).curves) {
            const Curve* theory = findCurve(figure(name), "theory: " + measured.name);
            if (!theory) continue;
            for (std::size_t i = 0; i < measured.points.size(); ++i) {
                const double expected = theory->points[i].error;
                if (std::isnan(expected) || expected > .2) continue;
                // Rounding of clip coordinates and of their quotient adds further steps.
                EXPECT_LT(measured.points[i].error, 4 * expected) << measured.name << " " << i;
                EXPECT_GT(measured.points[i].error, .3 * expected) << measured.name << " " << i;
            }
        }
}

TEST_F(Depth, FixedPointGapsGrowWithTheSquareOfTheDistance) {
    // The error is a share of the distance, which reduces the order by one.
    EXPECT_NEAR(fittedOrder(curve("gap-by-distance", "16 bit")), 1, .1);
}

TEST_F(Depth, ReversedFloatsFromZeroToOneHoldAtAnyRange) {
    const Curve* reversed = findCurve(figure("gap-by-range"), "32 bit float, reversed, 0..1");
    if (!reversed) GTEST_SKIP() << "this driver has no glClipControl";
    for (const Point& point : reversed->points) EXPECT_LT(point.error, 5e-7) << point.label;
}

TEST_F(Depth, PlanesSixteenStepsApartDoNotFightAndThoseAnEighthApartDo) {
    for (const Curve& each : figure("fighting").curves) {
        // With reversed floats, rounding may favour the nearer plane everywhere.
        if (each.name.find("reversed") == std::string::npos) {
            EXPECT_GT(each.points.front().error, .2) << each.name;
        }
        for (const Point& point : each.points)
            if (point.setting >= 16) {
                EXPECT_EQ(point.error, 0) << each.name << " " << point.label;
            }
    }
}

TEST_F(Depth, TheStateOfTheContextIsAsBefore) {
    Bench bench({.quick = true});
    (void)measureDepth(bench);
    GLint compare = 0;
    glGetIntegerv(GL_DEPTH_FUNC, &compare);
    EXPECT_EQ(compare, GL_LESS);
    EXPECT_EQ(glIsEnabled(GL_DEPTH_TEST), GL_FALSE);
}

}  // namespace
}  // namespace glibra::bench::test
