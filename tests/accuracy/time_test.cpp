#include <gtest/gtest.h>

#include <string>

#include "bench/core/figure.h"
#include "bench/subjects/subjects.h"
#include "samples.h"

namespace glibra::bench::test {
namespace {

using Time = FiguresOf<measureTime>;

TEST_F(Time, IsSound) {
    expectSound(figures);
}

TEST_F(Time, FloatsLoseTheFractionOfASecondAsTheyGrow) {
    EXPECT_NEAR(fittedOrder(curve("clock", "seconds as a float"), 3600, 1e6), 1, .15);
    // Half a step of a float of 600,000 seconds is 1/32 s.
    EXPECT_GT(curve("clock", "seconds as a float").points[4].error, .03);
    EXPECT_LT(curve("clock", "seconds reduced to ten in double").points.back().error, 1e-5);
}

TEST_F(Time, IntegratorsHaveTheOrdersOfTheirMethods) {
    EXPECT_NEAR(fittedOrder(curve("integrators", "Euler"), 512), -1, .4);
    EXPECT_NEAR(fittedOrder(curve("integrators", "Euler, speed first"), 256), -1, .15);
    EXPECT_NEAR(fittedOrder(curve("integrators", "midpoint"), 64, 512), -2, .3);
    EXPECT_NEAR(fittedOrder(curve("integrators", "leapfrog"), 32, 256), -2, .2);
    EXPECT_NEAR(fittedOrder(curve("integrators", "Runge-Kutta 4"), 16, 64), -4, .5);
}

TEST_F(Time, FindingsNameTheOrderWhereTheErrorHasOne) {
    const auto order = [](const std::string& in, const std::string& of) {
        for (const std::string& each : figure(in).findings)
            if (each.starts_with(of + ": error ")) return std::stod(each.substr(each.rfind('^') + 1));
        return 0.;
    };
    EXPECT_NEAR(order("integrators", "Euler"), -1, .4);
    EXPECT_NEAR(order("integrators", "Runge-Kutta 4"), -4, .5);
    EXPECT_NEAR(order("clock", "seconds as a float"), 1, .15);
}

}  // namespace
}  // namespace glibra::bench::test
