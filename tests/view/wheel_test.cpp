#include "view/scene/transforms.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace glibra::view {
namespace {

double sumOf(Wheel& wheel, const std::vector<double>& notches, double begin, double between) {
    double sum = 0;
    for (const double each : notches) {
        sum += wheel.take(each, begin);
        begin += between;
    }
    return sum;
}

TEST(Wheel, EveryNotchOfAMouseCounts) {
    Wheel wheel;
    EXPECT_EQ(sumOf(wheel, {1, 1, 1, -1, 1, 1, 1, 1}, 0, .01), 6);
    EXPECT_EQ(sumOf(wheel, {2, 1, 1, 1, 1}, 10, .01), 6);
}

TEST(Wheel, FingersScaleSmoothly) {
    Wheel wheel;
    const std::vector<double> fingers{.1, .15, .2, .2, .22, .2, .2, .21, .18, .2};
    EXPECT_NEAR(sumOf(wheel, fingers, 0, .016), std::accumulate(fingers.begin(), fingers.end(), 0.), 1e-12);
}

TEST(Wheel, MomentumIsLeftOut) {
    Wheel wheel;
    sumOf(wheel, {.3, .3, .3}, 0, .016);
    std::vector<double> momentum;
    double each = .28;
    for (int i = 0; i < 60; ++i, each *= .95) momentum.push_back(each);
    const double all = std::accumulate(momentum.begin(), momentum.end(), 0.);
    EXPECT_GT(all, 5);
    EXPECT_LT(sumOf(wheel, momentum, .048, .016), .6) << "two steps may pass before it is known as momentum";
}

TEST(Wheel, TheNextTouchCountsAgain) {
    Wheel wheel;
    sumOf(wheel, {.5, .4, .3, .2, .1}, 0, .016);
    EXPECT_EQ(wheel.take(.05, .08), 0);
    EXPECT_EQ(wheel.take(.05, 1), .05) << "after a pause";
    sumOf(wheel, {.5, .4, .3, .2, .1}, 2, .016);
    EXPECT_EQ(wheel.take(-.05, 2.09), -.05) << "in the other direction";
}

TEST(Wheel, ASuddenLargeStepIsLimited) {
    Wheel wheel;
    EXPECT_EQ(wheel.take(40, 0), 2);
    EXPECT_EQ(wheel.take(-40, 1), -2);
    EXPECT_EQ(wheel.take(0, 2), 0);
}

}  // namespace
}  // namespace glibra::view
