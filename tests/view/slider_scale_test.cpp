#include "view/scene/slider_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace glibra::view {
namespace {

using Ranges = std::vector<std::pair<double, double>>;

render::Knob knobOfRange(double minimum, double maximum, bool isInteger = false) {
    render::Knob knob;
    knob.widget = render::Widget::slider;
    knob.type.base = isInteger ? plan::BaseType::integer : plan::BaseType::floating;
    knob.minimum = minimum;
    knob.maximum = maximum;
    return knob;
}

TEST(SliderScale, EndsAreExact) {
    const Ranges ranges{{0, 1}, {-.123456789, 3.7}, {1e-9, 1e9}, {-1e308, 1e308}, {.1, .3}};
    for (const auto& [low, high] : ranges) {
        const SliderScale scale = scaleOf(knobOfRange(low, high));
        EXPECT_EQ(scale.valueAt(0), low);
        EXPECT_EQ(scale.valueAt(1), high);
        EXPECT_EQ(scale.valueAt(-5), low);
        EXPECT_EQ(scale.valueAt(7), high);
        EXPECT_EQ(scale.positionOf(low), 0);
        EXPECT_EQ(scale.positionOf(high), 1);
        EXPECT_EQ(scale.positionOf(low - 1e6), 0);
    }
}

TEST(SliderScale, PlacesAndValuesAgree) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(0, 1);
    for (const auto& [low, high] : Ranges{{0, 1}, {-2, 5}, {.01, 1000}, {1e-6, 1}, {100, 1e8}}) {
        const SliderScale scale = scaleOf(knobOfRange(low, high));
        for (int i = 0; i < 1000; ++i) {
            const double position = any(random);
            // A value is rounded to a thousandth of the range's power of ten, or on a logarithmic scale to
            // four digits.
            EXPECT_NEAR(scale.positionOf(scale.valueAt(position)), position, 1.01e-3) << low << ' ' << high;
            EXPECT_NEAR(scale.positionOf(scale.valueAt(position, true)), position, 1.01e-5);
        }
    }
}

TEST(SliderScale, ValuesAreShortNumbers) {
    const SliderScale scale = scaleOf(knobOfRange(0, 1));
    EXPECT_EQ(scale.valueAt(.3), .3);
    EXPECT_EQ(scale.valueAt(1. / 3), .333);
    EXPECT_EQ(scale.valueAt(1. / 3, true), .33333);
    EXPECT_EQ(scaleOf(knobOfRange(0, 500)).valueAt(1. / 3), 166.7);
}

TEST(SliderScale, TheMiddleOfASymmetricRangeIsZero) {
    const SliderScale scale = scaleOf(knobOfRange(-.3, .3));
    EXPECT_EQ(scale.valueAt(.5), 0);
    EXPECT_EQ(scale.valueAt(.5 + 1e-12), 0);
    EXPECT_FALSE(std::signbit(scale.valueAt(.5 - 1e-12)));
}

TEST(SliderScale, WidePositiveRangesAreLogarithmic) {
    EXPECT_TRUE(scaleOf(knobOfRange(.001, 1)).isLogarithmic);
    EXPECT_TRUE(scaleOf(knobOfRange(1, 1000, true)).isLogarithmic);
    EXPECT_FALSE(scaleOf(knobOfRange(.002, 1)).isLogarithmic);
    EXPECT_FALSE(scaleOf(knobOfRange(0, 1e9)).isLogarithmic);
    EXPECT_FALSE(scaleOf(knobOfRange(-1, 1e9)).isLogarithmic);
    const SliderScale scale = scaleOf(knobOfRange(.01, 100));
    EXPECT_DOUBLE_EQ(scale.positionOf(1), .5);
    EXPECT_DOUBLE_EQ(scale.valueAt(.25), .1);
}

TEST(SliderScale, MovesBySteps) {
    const SliderScale scale = scaleOf(knobOfRange(0, 2));
    EXPECT_EQ(scale.moved(1, .01), 1.02);
    EXPECT_EQ(scale.moved(1, -.1), .8);
    EXPECT_EQ(scale.moved(1, .001, true), 1.002);
    EXPECT_EQ(scale.moved(1.99, .1), 2);
    const SliderScale decades = scaleOf(knobOfRange(.01, 100));
    EXPECT_DOUBLE_EQ(decades.moved(1, .25), 10);
}

TEST(SliderScale, IntegersMoveByOneAtLeastAndStayInTheRange) {
    const SliderScale scale = scaleOf(knobOfRange(.5, 9.5, true));
    EXPECT_EQ(scale.moved(3, .01), 4);
    EXPECT_EQ(scale.moved(3, -.001, true), 2);
    EXPECT_EQ(scale.moved(9, .01), 9);
    EXPECT_EQ(scale.moved(1, -.01), 1);
    EXPECT_EQ(scale.valueAt(0), 1);
    EXPECT_EQ(scale.valueAt(1), 9);
    EXPECT_EQ(scaleOf(knobOfRange(0, 1000, true)).moved(500, .1), 600);
}

TEST(SliderScale, ExchangedAndEqualLimitsHaveAScale) {
    EXPECT_EQ(scaleOf(knobOfRange(3, 1)).valueAt(0), 1);
    EXPECT_EQ(scaleOf(knobOfRange(2, 2)).maximum, 3);
}

TEST(Leftovers, OfDraggingAreZeroAndOtherSmallNumbersStay) {
    EXPECT_EQ(withoutLeftover(-1.767e-15, .01), 0);
    EXPECT_EQ(withoutLeftover(1e-6, .01), 1e-6);
    EXPECT_EQ(withoutLeftover(-2.5, .01), -2.5);
}

}  // namespace
}  // namespace glibra::view
