// The second table of language, 5.3: counts and ranges.
#include <gtest/gtest.h>

#include "by_hand.h"
#include "plan/type_table.h"

namespace glibra::plan {
namespace {

using glib::UniformForm;
using test::ids;
using test::readingOf;
using test::textOf;
using test::Values;

Reading slider(const Values& values) {
    return readingOf("float", UniformForm::range, values);
}
void expectControl(const Reading& reading, double minimum, double current, double maximum) {
    ASSERT_TRUE(reading.control);
    EXPECT_EQ(reading.control->minimum, minimum);
    EXPECT_EQ(reading.control->current, current);
    EXPECT_EQ(reading.control->maximum, maximum);
    EXPECT_EQ(reading.values, Values{current});
}

TEST(ColourCount, OfThreeForFourComponentsHasAlphaOne) {
    const Reading reading = readingOf("vec4", UniformForm::color, {.1, .2, .3});
    EXPECT_EQ(reading.values, (Values{.1, .2, .3, 1}));
    EXPECT_TRUE(reading.diagnostics.empty());
}
TEST(ColourCount, OfFourForThreeComponentsDropsAlpha) {
    const Reading reading = readingOf("vec3", UniformForm::color, {.1, .2, .3, .4});
    EXPECT_EQ(reading.values, (Values{.1, .2, .3}));
    EXPECT_TRUE(reading.diagnostics.empty());
}
TEST(ColourCount, OfOneOrTwoIsFilledWithZerosAndAlphaOne) {
    EXPECT_EQ(readingOf("vec3", UniformForm::color, {.1}).values, (Values{.1, 0, 0}));
    EXPECT_EQ(readingOf("vec4", UniformForm::color, {.1, .2}).values, (Values{.1, .2, 0, 1}));
    EXPECT_EQ(ids(readingOf("vec4", UniformForm::color, {.1, .2}).diagnostics), "glib-W15");
}
TEST(ColourCount, BeyondFourIsSurplus) {
    const Reading reading = readingOf("vec4", UniformForm::color, {.1, .2, .3, .4, .5});
    EXPECT_EQ(reading.values, (Values{.1, .2, .3, .4}));
    EXPECT_EQ(ids(reading.diagnostics), "glib-W15");
}

TEST(RangeCount, OfOneReachesToZeroAndOne) {
    expectControl(slider({.5}), 0, .5, 1);
    expectControl(slider({-2}), -2, -2, 1);
    expectControl(slider({3}), 0, 3, 3);
    EXPECT_EQ(textOf(slider({.5}).diagnostics, "glib-W15"),
              "uA: 1 value in < >; read as minimum 0, current .5, maximum 1");
}
TEST(RangeCount, OfOneOnABoolTellsWhetherItIsNotZero) {
    const Reading reading = readingOf("bool", UniformForm::range, {2});
    EXPECT_EQ(reading.values, Values{1});
    EXPECT_EQ(textOf(reading.diagnostics, "glib-W15"), "uA: 1 value in < >; read as true");
    EXPECT_EQ(ids(reading.diagnostics), "glib-W15");
}
TEST(RangeCount, OfTwoIsMinimumAndCurrent) {
    expectControl(slider({.1, 1.5}), .1, 1.5, 1.5);
    EXPECT_EQ(textOf(slider({.1, 1.5}).diagnostics, "glib-W15"),
              "uA: 2 values in < >; read as minimum .1, current 1.5, maximum 1.5");
}
TEST(RangeCount, OfTwoFallingEndsAtTheLarger) {
    const Reading reading = slider({2, 1});  // min 2, cur 1, max 2
    expectControl(reading, 2, 1, 3);
    EXPECT_EQ(ids(reading.diagnostics), "glib-W15 glib-W22 glib-W21");
}
TEST(RangeCount, BeyondThreeIsSurplus) {
    expectControl(slider({0, 1, 2, 3}), 0, 1, 2);
    EXPECT_EQ(ids(slider({0, 1, 2, 3}).diagnostics), "glib-W15");
}
TEST(ListCount, BeyondTheTypeIsSurplus) {
    const Reading reading = readingOf("vec2", UniformForm::list, {1, 2, 3});
    EXPECT_EQ(reading.values, (Values{1, 2}));
    EXPECT_EQ(ids(reading.diagnostics), "glib-W15");
    EXPECT_EQ(readingOf("float[2]", UniformForm::list, {1, 2, 3}).values, (Values{1, 2}));
}
TEST(ListCount, BelowTheTypeLeavesTheRestZero) {
    const Reading reading = readingOf("vec3", UniformForm::list, {1, 2});
    EXPECT_EQ(reading.values, (Values{1, 2, 0}));
    EXPECT_EQ(textOf(reading.diagnostics, "glib-W15"), "uA: 2 values in [ ]; vec3 takes 3, so the rest is 0");
    EXPECT_EQ(readingOf("float[4]", UniformForm::list, {1}).values, (Values{1, 0, 0, 0}));
    EXPECT_EQ(readingOf("mat2", UniformForm::list, {1, 2, 3}).values, (Values{1, 2, 3, 0}));
}
TEST(EmptyBrackets, SkipTheTag) {
    for (const UniformForm form : {UniformForm::list, UniformForm::range, UniformForm::color}) {
        const Reading reading = readingOf("vec3", form, {});
        EXPECT_TRUE(reading.ignored);
        EXPECT_EQ(textOf(reading.diagnostics, "glib-W17"), "tag 'uA' has no value; it is skipped");
        EXPECT_EQ(reading.diagnostics.front().place.column, 3);
    }
}
TEST(RangeOrder, IsExchangedForTheSliderIfFalling) {
    const Reading reading = slider({.1, .05, .01});
    expectControl(reading, .01, .05, .1);
    EXPECT_EQ(textOf(reading.diagnostics, "glib-W22"),
              "uA: minimum .1 is above maximum .01; they are exchanged");
    EXPECT_EQ(reading.diagnostics.front().place.column, 9);
}
TEST(RangeOrder, OfEqualEndsIsWidenedByOne) {
    const Reading reading = slider({5, 5, 5});
    expectControl(reading, 5, 5, 6);
    EXPECT_EQ(ids(reading.diagnostics), "glib-W22");
}
TEST(RangeOrder, KeepsACurrentValueOutside) {
    const Reading reading = slider({.01, 1, .5});
    expectControl(reading, .01, 1, .5);
    EXPECT_EQ(textOf(reading.diagnostics, "glib-W21"),
              "uA: current value 1 is outside .01 ... .5; it is kept");
}
TEST(RangeOrder, DoesNotMatterWithoutASlider) {
    EXPECT_EQ(ids(readingOf("vec2", UniformForm::range, {5, 9, 1}).diagnostics), "glib-W20");
    EXPECT_EQ(ids(readingOf("bool", UniformForm::range, {1, 1, 1}).diagnostics), "glib-W20");
}

TEST(TypedValue, OfThreeNumbersForAVec4IsAnOpaqueColour) {
    const std::vector<double> values{0, 1, 0};
    const auto typed = [&](const char* word, UniformForm form, const char* text) {
        return readValue({"uColor", form, values, {}, {}, text}, test::uniform("uColor", word));
    };
    const Reading color = typed("vec4", UniformForm::list, "0,1,0");
    EXPECT_EQ(color.values, (Values{0, 1, 0, 1}));
    EXPECT_EQ(textOf(color.diagnostics, "glib-W15"),
              "--set uColor=0,1,0: 3 values; vec4 takes 4, so the last one is 1");
    EXPECT_EQ(typed("ivec4", UniformForm::list, "0,1,0").values, (Values{0, 1, 0, 0}));
    EXPECT_EQ(textOf(typed("vec2", UniformForm::list, "0,1,0").diagnostics, "glib-W15"),
              "--set uColor=0,1,0: 3 values; vec2 takes 2, so the surplus is ignored");
    EXPECT_EQ(textOf(typed("float", UniformForm::list, "0,1,0").diagnostics, "glib-W20"),
              "uColor is float, so --set uColor=0,1,0 is read as 0");
}

}  // namespace
}  // namespace glibra::plan
